// theme.js - the theme that the reader chose, before anything is painted: a small script that blocks, on purpose.
(() => {
    let chosen = null;
    try {
        chosen = localStorage.getItem("ray-casting theme");
    } catch {
        // A browser that keeps nothing uses the theme of the system.
    }
    if (chosen === "light" || chosen === "dark")
        document.documentElement.dataset.theme = chosen;
})();
