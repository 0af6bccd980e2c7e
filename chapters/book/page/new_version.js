// new_version.js - a page that was just opened changes to the new version of the site, if that is there and no other page
// of the site is open: those would load files of two versions.
export async function takeNewVersion() {
    // The first visit ends without a service worker for its page, so this is always another version.
    navigator.serviceWorker.addEventListener("controllerchange", () => location.reload());
    const registration = await navigator.serviceWorker.getRegistration();
    registration?.waiting?.postMessage("take over if one page is open");
}
