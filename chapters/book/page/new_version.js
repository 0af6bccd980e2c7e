// new_version.js - a page that was just opened changes to the new version of the site, if that is there and no other page
// of the site is open: those would load files of two versions.
const EVERY = 300, MOST = 10_000; // milliseconds

export async function takeNewVersion() {
    // The first visit ends without a service worker for its page, so this is always another version.
    navigator.serviceWorker.addEventListener("controllerchange", () => location.reload());
    const waiting = (await navigator.serviceWorker.getRegistration())?.waiting;
    if (!waiting)
        return;
    // The page before this one is open for a while longer, so this asks again, until the student begins to work.
    const ask = () => waiting.postMessage("take over if one page is open");
    const again = setInterval(ask, EVERY), stop = () => clearInterval(again);
    for (const kind of ["keydown", "pointerdown"])
        addEventListener(kind, stop, { once: true, capture: true });
    setTimeout(stop, MOST);
    ask();
}
