// webkit.mjs - the course in a page in WebKit, the engine of Safari: that a figure, the editor, a verdict, its picture and
// the download work, how soon there is a verdict, and that a later visit needs no network. Needs webkit2gtk-driver and xvfb.
//
// Usage: node tests/benches/webkit.mjs [SITE [VERDICTS [SCREENSHOT.png]]]
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { replaceInEditor, serve, waitFor } from "../proof/book/site.mjs";

const [folder = "build/book", verdicts = 10, shot] = process.argv.slice(2);
const stem = "05-quadratic", right = readFileSync(`solutions/${stem}.c`, "utf8");
const wrong = right.replace("= discriminant(even)", "= -discriminant(even)"), slip = right.replace(/;(?=\n\})/, "");
const show = (what, value, budget = "") => console.log(`${what.padEnd(44)} ${value.padStart(18)}   ${budget}`.trimEnd());
const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

const LIBRARIES = "/usr/lib/x86_64-linux-gnu";
const binary = readdirSync(LIBRARIES).filter((name) => name.startsWith("webkit2gtk-4")).map((name) => `${LIBRARIES}/${name}/MiniBrowser`).pop();
const free = () => new Promise((resolve) => {
    const probe = createServer().listen(0, "127.0.0.1", () => { const { port } = probe.address(); probe.close(() => resolve(port)); });
});
const port = await free(), host = await serve(folder, { compress: true });
// In a group of its own, so that all of it can be ended.
const driver = spawn("xvfb-run", ["-a", "WebKitWebDriver", `--port=${port}`], { detached: true, stdio: "ignore" });
let session = "";
async function ask(method, path, body) {
    const response = await fetch(`http://127.0.0.1:${port}${session}${path}`, { method, body: body && JSON.stringify(body), headers: { "content-type": "application/json" } });
    const { value } = await response.json();
    if (value?.error)
        throw new Error(`${value.error}: ${value.message}`);
    return value;
}
/** Runs a function in the page. */
const inPage = (run, ...given) => ask("POST", "/execute/sync", { script: `return (${run})(...arguments)`, args: given });
const go = (page) => ask("POST", "/url", { url: host.address + page });
const textOf = (selector) => inPage((each) => document.querySelector(each)?.textContent ?? "", selector);
const editorIsThere = () => inPage(() => Boolean(document.querySelector("#editor")?.shadowRoot?.querySelector(".cm-content")));
const verdictIsThere = () => inPage(() => Boolean(document.querySelector("#verdict pre[data-result]")) && !document.querySelector("#verdict").classList.contains("old"));

/** From a key to the verdict, in the page's own clock. */
const type = (text) => inPage(`async (text) => {
    const start = performance.now();
    (${replaceInEditor})(document.querySelector("#editor"), text, true);
    const until = async (isTrue) => { while (!isTrue()) await new Promise((resolve) => setTimeout(resolve, 2)); };
    await until(() => !document.querySelector("#verdict").classList.contains("old"));
    const took = performance.now() - start;
    await until(() => /judged/.test(document.querySelector("#state").textContent)); // and its pictures are drawn
    return took;
}`, text);

try {
    await waitFor("the driver", 30, () => ask("GET", "/status").catch(() => false));
    const { sessionId, capabilities } = await ask("POST", "/session", { capabilities: { alwaysMatch: { "webkitgtk:browserOptions": { binary, args: ["--automation"] } } } });
    session = `/session/${sessionId}`;
    await ask("POST", "/timeouts", { script: 300_000, pageLoad: 120_000 });
    const begin = Date.now();
    await go(`${stem}.html`);
    await waitFor("a live figure", 120, () => inPage(() => Boolean(document.querySelector(".figure.live"))));
    show("first live figure", `${((Date.now() - begin) / 1000).toFixed(2)} s`);
    await inPage(() => document.querySelector("#judge").click());
    await waitFor("a verdict", 300, verdictIsThere);
    show("first verdict", `${((Date.now() - begin) / 1000).toFixed(2)} s`);
    await waitFor("an editor", 60, editorIsThere);
    for (const text of [right, wrong, slip, right, wrong, slip])
        await type(text);
    const times = { verdict: [], slip: [] };
    for (let i = 0; i < verdicts; i++) {
        times.verdict.push(await type(`${i % 2 ? right : wrong}// ${i}\n`));
        times.slip.push(await type(`${slip}// ${i}\n`));
    }
    show("from a key to the verdict, median", `${median(times.verdict).toFixed(0)} ms`, "at most 1000 ms");
    show("  a missing semicolon", `${median(times.slip).toFixed(0)} ms`);

    await type(wrong);
    await waitFor("the figure of the verdict", 60, () => inPage(() => document.querySelector("#verdict-pictures img")?.naturalWidth > 0));
    await type(right);
    assert.match(await textOf("#verdict"), /05-quadratic is right/);
    await waitFor("the picture", 60, () => inPage(() => document.querySelector("#verdict-pictures img")?.naturalWidth > 0));
    if (shot) {
        await inPage(() => document.querySelector("#exercise").scrollIntoView());
        writeFileSync(shot, Buffer.from(await ask("GET", "/screenshot"), "base64"));
    }
    const drag = await inPage(async () => {
        const root = document.querySelector('.figure[data-figure="ray-sphere"] .drawing > div').shadowRoot, input = root.querySelector("input[name=radius]");
        const title = root.querySelector("svg desc").textContent;
        input.value = "2";
        input.dispatchEvent(new Event("change", { bubbles: true }));
        for (let i = 0; i < 600 && root.querySelector("svg desc").textContent === title; i++)
            await new Promise((resolve) => setTimeout(resolve, 50));
        return root.querySelector("svg desc").textContent !== title;
    });
    assert.ok(drag, "a figure follows a number");
    const keeps = await inPage(async () => {
        for (let i = 0; navigator.serviceWorker && i < 1200; i++) {
            if ((await navigator.serviceWorker.getRegistration())?.active)
                return true;
            await new Promise((resolve) => setTimeout(resolve, 100));
        }
        return false;
    });
    if (keeps)
        host.stopSending();
    await go("index.html");
    assert.match(await waitFor("progress", 20, () => textOf("#so-far")), /functions? (is|are) right/);
    const archive = await inPage(async () => {
        const make = URL.createObjectURL;
        let saved;
        URL.createObjectURL = (blob) => { saved = blob.arrayBuffer(); return make.call(URL, blob); };
        document.querySelector("#download").click();
        while (!saved) // the page's script may not be there yet
            await new Promise((resolve) => setTimeout(resolve, 50));
        return [...new Uint8Array(await saved)].slice(0, 2);
    });
    assert.deepEqual(archive, [0x50, 0x4b], "the archive is a zip file");
    show("a later visit without a network", keeps ? "works" : "not tested: no service worker");
    console.log(`${capabilities.browserName} ${capabilities.browserVersion}, ${verdicts} verdicts of each kind`);
} finally {
    if (session)
        await ask("DELETE", "").catch(() => {});
    process.kill(-driver.pid, "SIGTERM");
    await host.stop();
}
