// service_worker.js - keeps the site for use without a network, and answers later visits without one byte of it.
//
// FILES is written when the site is built: the path of each file, and the SHA-256 of its contents. A page and all that it
// loads are of one version. A new version is kept beside the old one, where files that have not changed are not fetched
// again. It takes over when a page is opened and no other page of the site is open.
/* global FILES, ORDER */
const CACHE = "ray-casting " + new URL(registration.scope).pathname;
const keyOf = (path) => new URL(`${path}?${FILES[path]}`, registration.scope).href;

/** A file of this version; a host may already have another one, or still have one. */
async function fetchFile(path) {
    const response = await fetch(new URL(path, registration.scope), { cache: "no-cache" });
    if (!response.ok)
        throw new Error(`${path}: the host says ${response.status}`);
    const bytes = await response.arrayBuffer();
    const hash = [...new Uint8Array(await crypto.subtle.digest("SHA-256", bytes))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
    if (hash !== FILES[path])
        throw new Error(`${path}: the host has another version`);
    // Without clone(): of two bodies the one that nobody reads stays in memory. And a page may not be a redirected response.
    const type = response.headers.get("content-type");
    return () => new Response(bytes, { headers: type ? { "content-type": type } : {} });
}

/** Keeps a file that is not kept yet. Returns a function that makes the response to a page. */
async function keep(path) {
    const cache = await caches.open(CACHE), before = await cache.match(keyOf(path));
    if (before)
        return () => before;
    const response = await fetchFile(path);
    await cache.put(keyOf(path), response());
    return response;
}

addEventListener("install", (event) => {
    event.waitUntil((async () => {
        // One after the other, small ones first: a student who reads should not notice.
        for (const path of ORDER)
            await keep(path);
    })());
});

addEventListener("activate", (event) => {
    event.waitUntil((async () => {
        const cache = await caches.open(CACHE), wanted = new Set(Object.keys(FILES).map(keyOf));
        for (const request of await cache.keys())
            if (!wanted.has(request.url))
                await cache.delete(request);
    })());
});

// A page that was just opened asks for this, more than once (page.js).
addEventListener("message", (event) => {
    if (event.data === "take over if one page is open")
        event.waitUntil((async () => {
            const open = (await clients.matchAll({ type: "window", includeUncontrolled: true })).filter(({ url }) => url.startsWith(registration.scope));
            if (open.length !== 1)
                return;
            open[0].postMessage("the new version takes over");
            await skipWaiting();
        })());
});

addEventListener("fetch", (event) => {
    const { scope } = registration;
    const url = new URL(event.request.url);
    if (event.request.method !== "GET" || !url.href.startsWith(scope))
        return;
    const path = decodeURIComponent(url.href.slice(scope.length).replace(/[?#].*$/, "")).replace(/(^|\/)$/, "$1index.html");
    if (FILES[path] === undefined)
        return;
    event.respondWith(keep(path).then((response) => response()).catch((reason) => new Response(reason.message, { status: 504 })));
});
