// offline.js - the service worker is started after the first work is done, so that it does not compete with it.
export function keepForOffline(site) {
    const start = () => navigator.serviceWorker.register(new URL("service_worker.js", site), { scope: site.pathname }).catch(() => {});
    if (document.readyState === "complete")
        setTimeout(start, 1500);
    else
        addEventListener("load", () => setTimeout(start, 1500));
}
