// webkit.mjs - the site in WebKitGTK, which puppeteer cannot drive: a live figure is dragged, a verdict is right and then wrong,
// the scene and a gallery are cast, and the lecture has live figures. Its engine is slow where it only interprets.
//
// Usage: node webkit.mjs SITE. Wants Debian's webkit2gtk-driver and xvfb.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import test, { after } from "node:test";
import { replaceInEditor, serve, waitFor } from "./site.mjs";

const PORT = 4477, DISPLAY = `:${PORT}`, BROWSER = "/usr/lib/x86_64-linux-gnu/webkit2gtk-4.1/MiniBrowser";
const host = await serve(process.argv[2]), stem = "05-quadratic", right = readFileSync(`solutions/${stem}.c`, "utf8");
const programs = [spawn("Xvfb", [DISPLAY, "-screen", "0", "1440x900x24"], { stdio: "ignore" }),
    spawn("WebKitWebDriver", [`--port=${PORT}`], { stdio: "ignore", env: { ...process.env, DISPLAY } })];

async function ask(method, path, body) {
    const { value } = await (await fetch(`http://127.0.0.1:${PORT}/session${path}`, { method, body: body && JSON.stringify(body) })).json();
    assert.equal(value?.error, undefined, value?.message);
    return value;
}
const options = { binary: BROWSER, args: ["--automation"] };
const { sessionId } = await waitFor("a browser", () => ask("POST", "", { capabilities: { alwaysMatch: { "webkitgtk:browserOptions": options } } }).catch(() => null));
after(async () => {
    await ask("DELETE", `/${sessionId}`);
    programs.forEach((each) => each.kill());
    await host.stop();
});
const visit = (path) => ask("POST", `/${sessionId}/url`, { url: host.address + path });
/** A function that is run in the page. */
const run = (does, ...args) => ask("POST", `/${sessionId}/execute/sync`, { script: `return (${does})(...arguments)`, args });
const until = (what, does, ...args) => waitFor(what, () => run(does, ...args).catch(() => null));
const answer = (text) => run(`(text) => (${replaceInEditor})(document.querySelector("#editor"), text, true)`, text);
const verdict = (result) => until(`a verdict that is ${result}`, (wanted) =>
    document.querySelector("#progress").hidden && document.querySelector("#verdict").dataset.result === wanted && document.querySelector("#first").textContent, result);

test("WebKitGTK", async (t) => {
    await t.test("a live figure is dragged", async () => {
        await visit(`${stem}.html`);
        // A pointer that a script makes cannot be captured.
        const was = await until("a live figure", () => {
            const handle = document.querySelector(".figure.live .drawing > div")?.shadowRoot.querySelector(".handle:not([hidden])"), box = handle?.getBoundingClientRect();
            if (!handle)
                return null;
            const label = handle.getAttribute("aria-label");
            Object.assign(handle, { setPointerCapture() {}, hasPointerCapture: () => true });
            for (const [kind, far] of [["down", 0], ["move", 20], ["move", 40], ["up", 40]])
                handle.dispatchEvent(new PointerEvent(`pointer${kind}`, { pointerId: 1, button: 0, clientX: box.x + 22 + far, clientY: box.y + 22 - far }));
            return label;
        });
        await until("a figure that has changed", (before) =>
            document.querySelector(".figure.live .drawing > div").shadowRoot.querySelector(".handle:not([hidden])").getAttribute("aria-label") !== before, was);
    });
    await t.test("a wrong answer is named, the scene is cast by it, and a right one opens the gallery", async () => {
        await until("an editor", () => Boolean(document.querySelector("#editor").shadowRoot?.querySelector(".cm-content")));
        await answer(right.replace("- radius * radius", "- radius"));
        assert.match(await verdict("wrong"), /square r/);
        await until("a scene", () => Boolean(document.querySelector(".live-scene canvas[data-fine]")));
        await answer(right);
        assert.match(await verdict("right"), /05-quadratic is right/);
        await visit(`mistakes.html#${stem}`);
        await until("a picture by a mistake", () => Boolean(document.querySelector("#question canvas[data-fine]")));
    });
    await t.test("the lecture has live figures", async () => {
        await visit("lecture.html");
        await run(() => { location.hash = `#${document.querySelector("#stage section:has([data-figure])").id}`; });
        await until("a live figure", () => Boolean(document.querySelector("#stage .live")));
    });
});
