// early.js - what cannot wait for the page's script: the theme that the reader chose, before anything is painted, and
// clicks on buttons that are not ready yet. A small script that blocks, on purpose.
(() => {
    let chosen = null;
    try {
        chosen = localStorage.getItem("ray-casting theme");
    } catch {
        // A browser that keeps nothing uses the theme of the system.
    }
    if (chosen === "light" || chosen === "dark")
        document.documentElement.dataset.theme = chosen;

    const clicked = new Set();
    function note({ target }) {
        const button = target.closest(".actions button, [role=tab]");
        if (button)
            clicked.add(button);
    }
    addEventListener("click", note, true);
    /** The page's script calls this when its buttons work: they are clicked again. */
    globalThis.takeEarlyClicks = () => {
        removeEventListener("click", note, true);
        clicked.forEach((button) => button.click());
    };
})();
