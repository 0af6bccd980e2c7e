// early.js - what cannot wait for the page's script: what the reader chose, before anything is painted, and
// clicks on buttons that are not ready yet. A small script that blocks, on purpose.
(() => {
    const root = document.documentElement;
    let chosen = null, lesson = null; // the theme, and how much room a lesson has
    try {
        chosen = localStorage.getItem("ray-casting theme");
        lesson = localStorage.getItem("ray-casting lesson");
    } catch {
        // A browser that keeps nothing uses the theme of the system.
    }
    if (chosen === "light" || chosen === "dark")
        root.dataset.theme = chosen;
    root.dataset.js = "";
    if (lesson)
        root.style.setProperty("--lesson", lesson);
    if (root.dataset.kind === "chapter")
        root.dataset.view = location.hash === "#exercise" ? "code" : "lesson";

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
