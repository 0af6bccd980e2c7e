// site.mjs - for tests in a browser: the site on a port of its own, a browser, and what both must never do.
//
// BROWSER=firefox takes Firefox, otherwise it is Chromium: the first in PATH, or the one that FIREFOX or CHROMIUM names.
import { execSync } from "node:child_process";
import { existsSync, readFileSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { extname, join, normalize } from "node:path";
import { after } from "node:test";
import { gzipSync } from "node:zlib";

const require = createRequire(new URL("../../../chapters/book/package.json", import.meta.url));
const puppeteer = require("puppeteer-core");
const axeSource = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

const TYPES = { ".html": "text/html; charset=utf-8", ".css": "text/css", ".js": "text/javascript", ".json": "application/json", ".svg": "image/svg+xml",
    ".png": "image/png", ".woff2": "font/woff2", ".wasm": "application/wasm" };

/** The folder as a static host serves it, in a folder of the host. rate: bits per second, of all connections together. */
export async function serve(folder, { compress = false, at = "/course/", rate = Infinity } = {}) {
    const sent = { bytes: 0, requests: [], log: [] }; // log: when, how many, and of which path
    let free = 0, isOff = false, held = null;
    async function send(response, body, path) {
        for (let from = 0, size = rate < Infinity ? 1 << 13 : body.length; from < body.length && !response.destroyed; from += size) {
            const part = body.subarray(from, from + size), now = performance.now();
            free = Math.max(free, now) + part.length * 8000 / rate;
            if (free > now)
                await new Promise((resolve) => setTimeout(resolve, free - now));
            response.write(part);
            sent.bytes += part.length;
            sent.log.push([Date.now(), part.length, path]);
        }
        response.end();
    }
    const server = createServer((request, response) => {
        const path = decodeURIComponent(new URL(request.url, "http://x").pathname);
        sent.requests.push(path);
        if (isOff)
            return request.socket.destroy();
        if (held?.pattern.test(path))
            return held.waiting.push(() => answer(request, response));
        return answer(request, response);
    });
    function answer(request, response) {
        const path = decodeURIComponent(new URL(request.url, "http://x").pathname);
        const file = join(folder, normalize(path.slice(at.length - 1)).replace(/\/$/, "/index.html"));
        if (!path.startsWith(at) || !existsSync(file) || !statSync(file).isFile()) {
            response.writeHead(404).end();
            return;
        }
        const headers = { "content-type": TYPES[extname(file)] ?? "application/octet-stream", "cache-control": "no-cache" };
        if (compress && /\.(html|css|js|json|svg|wasm)$/.test(file)) {
            const body = gzipSync(readFileSync(file));
            response.writeHead(200, { ...headers, "content-encoding": "gzip", "content-length": body.length });
            return send(response, body, path);
        }
        const body = readFileSync(file);
        response.writeHead(200, { ...headers, "content-length": body.length });
        return send(response, body, path);
    }
    /** Paths like that are not answered until the function that it returns is called. */
    function hold(pattern) {
        const mine = held = { pattern, waiting: [] };
        return () => {
            held = null;
            mine.waiting.forEach((go) => go());
        };
    }
    await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
    const stop = () => new Promise((resolve) => { server.closeAllConnections(); server.close(resolve); });
    return { address: `http://127.0.0.1:${server.address().port}${at}`, sent, stop, hold, stopSending() { isOff = true; } };
}

export const browserName = process.env.BROWSER === "firefox" ? "firefox" : "chromium";
const NAMES = { chromium: "chromium chromium-browser google-chrome", firefox: "firefox-esr firefox" };
const program = process.env[browserName.toUpperCase()] ??
    execSync(`for name in ${NAMES[browserName]}; do command -v $name && break; done`, { encoding: "utf8" }).trim();

/** What no page of a chapter says: commands, files and programs of a terminal. */
export const FOR_A_TERMINAL = /\bmake ([a-z]+ )?(EX|TASK|ANSWERS|FIGURE)=|\bmake (exercises|hint|debug|watch|figures|optional)|gnuplot|\bbuild\/|README|\.(svg|png|gp|nff)\b|(^|\s)--[a-z]/;

/** Milliseconds: for what hangs. A test waits for what happens, however busy the machine is. */
const HANGS = Number(process.env.HANGS) || 900_000;
const SILENT = 30_000; // after so many the page ends a Worker (worker_questions.js); in tests, after HANGS

export function launch() {
    const given = { executablePath: program, headless: true, timeout: HANGS, protocolTimeout: HANGS };
    return puppeteer.launch(browserName === "firefox" ? { browser: "firefox", ...given }
        : { args: ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"], ...given });
}

/**
 * For a file of tests, 'node NAME.mjs SITE [FOLDER-FOR-SCREENSHOTS]': the site or another folder, and a browser, which end after
 * the last test. openPage(path, size) opens a page of it in a tab of its own.
 */
export async function begin(folder = process.argv[2]) {
    const host = await serve(folder), browser = await launch();
    after(async () => {
        await browser.close();
        await host.stop();
    });
    const openPage = async (path, size) => {
        const tab = await openTab(browser, host.address, size);
        await tab.visit(path);
        return tab;
    };
    return { folder, host, browser, openPage };
}

/**
 * A tab that notes what a page must not do: errors, messages of the policy, requests to another origin. Beside what every tab
 * can: visit(path), text(selector), press(selector), which clicks wherever that is, and shot(name, part), if screenshots are wanted.
 */
export async function openTab(browser, site, { width = 1280, height = 800 } = {}) {
    const tab = await browser.newPage();
    tab.faults = [];
    tab.on("pageerror", (error) => tab.faults.push(`error: ${error.message}`));
    tab.on("console", (message) => {
        if (message.type() === "error")
            tab.faults.push(`console: ${message.text()}`);
    });
    tab.on("request", (request) => {
        if (!request.url().startsWith(new URL(site).origin) && !/^(data|blob|about):/.test(request.url()))
            tab.faults.push(`another origin: ${request.url()}`);
    });
    tab.setDefaultTimeout(HANGS);
    tab.setDefaultNavigationTimeout(HANGS);
    await tab.evaluateOnNewDocument((silent, hangs) => {
        const { setTimeout } = globalThis;
        globalThis.setTimeout = (then, milliseconds, ...more) => setTimeout(then, milliseconds === silent ? hangs : milliseconds, ...more);
    }, SILENT, HANGS);
    await tab.setViewport({ width, height });
    const shots = process.argv[3];
    return Object.assign(tab, {
        async visit(path) {
            await tab.goto(site + path, { waitUntil: "load" });
            if (await tab.$("#editor"))
                await waitForEditor(tab);
        },
        text: (selector) => tab.$eval(selector, (each) => each.textContent),
        press: (selector) => tab.$eval(selector, (each) => each.click()),
        shot: async (name, part = tab) => shots && part.screenshot({ path: join(shots, `${name}-${browserName}.png`) }),
    });
}

/** What axe-core finds of these impacts, as one line each. It tries a style element, which is not the page's fault. */
export async function findings(tab, impacts) {
    const { faults } = tab;
    tab.faults = [];
    await tab.evaluate(axeSource);
    const found = await tab.evaluate(async () => {
        const { violations } = await globalThis.axe.run(document, { resultTypes: ["violations"] });
        return violations.map(({ id, impact, help, nodes }) => ({ impact, line: `${id}: ${help}: ${nodes.slice(0, 3).map(({ target }) => target.join(" ")).join(", ")}` }));
    });
    tab.faults = faults;
    return found.filter(({ impact }) => impacts.test(impact)).map(({ line }) => line);
}
export const seriousFindings = (tab) => findings(tab, /serious|critical/);

/** Until then the page shows the text without an editor. */
export const waitForEditor = (tab) => waitFor("an editor", () => tab.$eval("#editor", (place) => Boolean(place.shadowRoot?.querySelector(".cm-content"))));

/** The text of the editor, and typing over it. */
export const editorText = (tab) => tab.$eval("#editor", (place) =>
    [...place.shadowRoot.querySelectorAll(".cm-line")].map((line) => line.textContent).join("\n"));

/** A complete verdict with these words. */
export const hasVerdict = async (tab, wanted) => wanted.test(await tab.text("#verdict")) && await tab.$eval("#progress", (each) => each.hidden);

export async function waitFor(what, probe) {
    const end = Date.now() + HANGS;
    for (;;) {
        const value = await probe();
        if (value)
            return value;
        if (Date.now() > end)
            throw new Error(`after ${HANGS / 1000} s: not ${what}`);
        await new Promise((resolve) => setTimeout(resolve, 50));
    }
}

/** Another text in the editor, as if it was pasted, at once; judge: and Ctrl-Enter. Runs in the page. */
export function replaceInEditor(place, text, judge) {
    const content = place.shadowRoot.querySelector(".cm-content");
    content.focus();
    const press = (key, code, keyCode) =>
        content.dispatchEvent(new KeyboardEvent("keydown", { key, code, keyCode, ctrlKey: true, bubbles: true, composed: true, cancelable: true }));
    press("a", "KeyA", 65);
    // Firefox gives no clipboard to an event that a script makes.
    const paste = new Event("paste", { bubbles: true, cancelable: true });
    paste.clipboardData = { getData: (type) => type === "text/plain" ? text : "", files: [] };
    content.dispatchEvent(paste);
    if (judge)
        press("Enter", "Enter", 13);
}
export const replaceText = (tab, text, { judge = false } = {}) => tab.$eval("#editor", replaceInEditor, text, judge);

/** Types a new last line. */
export async function typeAtEnd(tab, text) {
    await tab.$eval("#editor", (place) => place.shadowRoot.querySelector(".cm-content").focus());
    await tab.keyboard.down("Control");
    await tab.keyboard.press("End");
    await tab.keyboard.up("Control");
    if (text !== "\t")
        await tab.keyboard.press("Enter");
    for (const letter of text)
        await tab.keyboard.press(letter === "\t" ? "Tab" : letter);
}
