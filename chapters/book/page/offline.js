// offline.js - the site without a network, and its new versions.

// The service worker is started after the first work is done, so that it does not compete with it: what it
// fetches is ten times what the first verdict needs.
const LATEST = 60_000; // milliseconds, if the work does not end

export function keepForOffline(site) {
    const start = () => navigator.serviceWorker.register(new URL("service_worker.js", site), { scope: site.pathname }).catch(() => {});
    if (document.getElementById("editor") && !globalThis.judgeIsReady) {
        addEventListener("judge-ready", start, { once: true });
        setTimeout(start, LATEST);
    } else if (document.readyState === "complete")
        setTimeout(start, 1500);
    else
        addEventListener("load", () => setTimeout(start, 1500));
}

// ---- a new version --------------------------------------------------------------------------------

// A page that was just opened changes to the new version of the site, if that is there and no other page
// of the site is open: those would load files of two versions.
//
// Nothing else of the page begins before that. A browser waits until the old service worker has nothing to do, and the
// page's Workers would give it work. It may wait for half a minute then, and a student would see the page load again.
const EVERY = 100, MOST = 2000; // milliseconds

export async function takeNewVersion() {
    // The first visit ends without a service worker for its page, so this is always another version.
    navigator.serviceWorker.addEventListener("controllerchange", () => location.reload());
    const waiting = (await navigator.serviceWorker.getRegistration())?.waiting;
    if (!waiting)
        return;
    const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
    let takesOver = false;
    navigator.serviceWorker.addEventListener("message", ({ data }) => { takesOver ||= data === "the new version takes over"; });
    navigator.serviceWorker.startMessages();
    // The page before this one may be open for a moment longer, so this asks again.
    for (let waited = 0; waited < MOST && !takesOver; waited += EVERY) {
        waiting.postMessage("take over if one page is open");
        await pause(EVERY);
    }
    if (takesOver)
        await pause(MOST);
}
