// site.mjs - for tests in a browser: the site on a port of its own, and a browser that refuses any other origin.
//
// BROWSER=firefox takes Firefox, else it is Chromium. Each test ends the browser and the server that it started.
import { createReadStream, existsSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { gzipSync } from "node:zlib";
import { readFileSync } from "node:fs";
import puppeteer from "puppeteer-core";

const TYPES = { ".html": "text/html; charset=utf-8", ".css": "text/css", ".js": "text/javascript", ".json": "application/json", ".svg": "image/svg+xml",
    ".png": "image/png", ".woff2": "font/woff2", ".wasm": "application/wasm" };

/** The folder as a static host serves it. `answered` counts the bytes that were sent. */
export async function serve(folder, { compress = false } = {}) {
    const sent = { bytes: 0, requests: 0 };
    const server = createServer((request, response) => {
        const path = normalize(decodeURIComponent(new URL(request.url, "http://x").pathname)).replace(/\/$/, "/index.html");
        const file = join(folder, path);
        sent.requests += 1;
        if (!existsSync(file) || !statSync(file).isFile()) {
            response.writeHead(404).end();
            return;
        }
        const headers = { "content-type": TYPES[extname(file)] ?? "application/octet-stream", "cache-control": "no-cache" };
        if (compress && /\.(html|css|js|json|svg|wasm)$/.test(file)) {
            const body = gzipSync(readFileSync(file), { level: 6 });
            sent.bytes += body.length;
            response.writeHead(200, { ...headers, "content-encoding": "gzip", "content-length": body.length }).end(body);
            return;
        }
        const { size } = statSync(file);
        sent.bytes += size;
        response.writeHead(200, { ...headers, "content-length": size });
        createReadStream(file).pipe(response);
    });
    await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
    const stop = () => new Promise((resolve) => { server.closeAllConnections(); server.close(resolve); });
    return { address: `http://127.0.0.1:${server.address().port}/`, sent, stop };
}

export const browserName = process.env.BROWSER === "firefox" ? "firefox" : "chromium";

export function launch() {
    return browserName === "firefox"
        ? puppeteer.launch({ browser: "firefox", executablePath: process.env.FIREFOX ?? "/usr/bin/firefox-esr", headless: true, protocolTimeout: 240_000 })
        : puppeteer.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", headless: true, protocolTimeout: 240_000,
            args: ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"] });
}
