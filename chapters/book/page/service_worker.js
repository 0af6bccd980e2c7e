// service_worker.js - keeps the site for use without a network, and answers later visits without one byte of it.
//
// FILES is written when the site is built: the path of each file, and a name of its contents. A file whose contents have
// changed has another name, so only such files are fetched again.
/* global FILES, ORDER */
const CACHE = "ray-casting " + new URL(registration.scope).pathname;
const keyOf = (path) => new URL(`${path}?${FILES[path]}`, registration.scope).href;

async function keep(cache, path) {
    const key = keyOf(path);
    if (await cache.match(key))
        return;
    const response = await fetch(new URL(path, registration.scope), { cache: "no-cache" });
    if (response.ok)
        await cache.put(key, response);
}

addEventListener("install", (event) => {
    event.waitUntil((async () => {
        const cache = await caches.open(CACHE);
        // One after the other, small ones first: a student who reads should not notice.
        for (const path of ORDER)
            await keep(cache, path);
        await skipWaiting();
    })());
});

addEventListener("activate", (event) => {
    event.waitUntil((async () => {
        const cache = await caches.open(CACHE), wanted = new Set(Object.keys(FILES).map(keyOf));
        for (const request of await cache.keys())
            if (!wanted.has(request.url))
                await cache.delete(request);
        await clients.claim();
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
    event.respondWith((async () => {
        const cache = await caches.open(CACHE), kept = await cache.match(keyOf(path));
        if (kept)
            return kept;
        const response = await fetch(event.request);
        if (response.ok && response.status === 200)
            await cache.put(keyOf(path), response.clone());
        return response;
    })());
});
