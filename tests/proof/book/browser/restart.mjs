// restart.mjs - the judge in a real browser when something goes wrong: a click before the page's script is there, a
// compilation without an end, an answer that takes all memory, a Worker that stops. The next answer gets its verdict.
//
// Usage: BROWSER=chromium|firefox node restart.mjs SITE
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { begin, hasVerdict, openTab, replaceText, waitFor, waitForEditor } from "../site.mjs";

const stem = "05-quadratic", right = readFileSync(`solutions/${stem}.c`, "utf8");
const { host, browser } = await begin();
const verdict = (tab, what, wanted) => waitFor(`the verdict: ${what}`, () => hasVerdict(tab, wanted));

/** Macros whose expansion has 2^40 parts, none of which is left: the compiler takes no memory, and does not end. */
const ENDLESS = `#define A0\n${Array.from({ length: 40 }, (_, i) => `#define A${i + 1} A${i} A${i}\n`).join("")}A40\n`;
/** Takes memory, and uses it, until there is none. */
const GREEDY = right.replace(/Roots quadratic_roots\(Quadratic q\)\s*\{/, (start) =>
    `#include <stdlib.h>\n${start}\n    for (int i = 0; i < 1000; i++) {\n        char *p = malloc(1 << 28);\n        p[0] = 1;\n    }\n`);
const WRONG = right.replace("q.b * q.b - 4", "q.b * q.b + 4"), IS_WRONG = /quadratic_roots, not right yet/;
assert.ok(GREEDY !== right && WRONG !== right);

test("the next answer gets its verdict after a failure", async () => {
    const tab = await openTab(browser, host.address);
    await tab.evaluateOnNewDocument(() => {
        globalThis.workers = [];
        globalThis.Worker = class extends Worker {
            constructor(...given) {
                super(...given);
                globalThis.workers.push(this);
            }
        };
    });
    const release = host.hold(/\/page\.js$/), opening = tab.goto(`${host.address}${stem}.html`, { waitUntil: "load" });
    await waitFor("a button", () => tab.$("#judge").catch(() => null));
    await tab.press("#judge");
    release();
    await opening;
    await verdict(tab, "a click before the page's script", /not answered yet/);

    await waitForEditor(tab);
    await replaceText(tab, GREEDY, { judge: true });
    await verdict(tab, "all memory", /(?=[^]*quadratic_roots)(?=[^]*(crash|address|memory))/i);
    await replaceText(tab, right, { judge: true });
    await verdict(tab, "after an answer that took all memory", /05-quadratic is right/);

    // The time after which a Worker is ended, shortened: the next ones are warm by now.
    await tab.evaluate(() => {
        globalThis.realTimeout = setTimeout;
        globalThis.setTimeout = (then, milliseconds, ...more) => globalThis.realTimeout(then, milliseconds === 30_000 ? 3000 : milliseconds, ...more);
    });
    await replaceText(tab, `${right}\n${ENDLESS}`, { judge: true });
    await waitFor("words about a compilation without an end", async () => /ended and starts again.*Your answer is saved/.test(await tab.text("#trouble")));
    await tab.evaluate(() => { globalThis.setTimeout = globalThis.realTimeout; });
    await replaceText(tab, WRONG, { judge: true });
    await verdict(tab, "after a compilation without an end", IS_WRONG);
    assert.equal(await tab.text("#trouble"), "");

    // A Worker that stops by itself is started again, and the student sees only the verdict.
    await tab.reload({ waitUntil: "load" });
    await waitForEditor(tab);
    await verdict(tab, "of the saved answer", IS_WRONG);
    await tab.evaluate(() => globalThis.workers.forEach((worker) => {
        worker.postMessage = () => {
            worker.terminate();
            setTimeout(() => worker.dispatchEvent(new ErrorEvent("error", { message: "the test stopped it" })));
        };
    }));
    await replaceText(tab, right, { judge: true });
    await verdict(tab, "after a Worker stopped", /05-quadratic is right/);
    assert.deepEqual(tab.faults, []);
});
