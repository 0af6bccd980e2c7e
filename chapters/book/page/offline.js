// offline.js - the service worker is started after the first work is done, so that it does not compete with it: what it
// fetches is ten times what the first verdict needs.
const MOST = 60_000; // milliseconds, if the work does not end

export function keepForOffline(site) {
    const start = () => navigator.serviceWorker.register(new URL("service_worker.js", site), { scope: site.pathname }).catch(() => {});
    if (document.getElementById("editor") && !globalThis.judgeIsReady) {
        addEventListener("judge-ready", start, { once: true });
        setTimeout(start, MOST);
    } else if (document.readyState === "complete")
        setTimeout(start, 1500);
    else
        addEventListener("load", () => setTimeout(start, 1500));
}
