// book.mjs - the course in a page, measured in a real browser: how soon it shows something, how soon there is a verdict,
// what it takes, and how often a second what is dragged is drawn.
//
// The host sends at a given rate, over all connections together, as a network does; a browser's own throttling leaves out
// what a Worker fetches. Usage: BROWSER=chromium|firefox node tests/benches/book.mjs [SITE [MBIT [VERDICTS]]]
import { readFileSync, readdirSync } from "node:fs";
import { editorText, launch, openTab, replaceInEditor, serve, waitFor, waitForEditor } from "../proof/book/site.mjs";

const [folder = "build/book", mbit = 10, verdicts = 20] = process.argv.slice(2);
const stem = "05-quadratic", right = readFileSync(`solutions/${stem}.c`, "utf8");
const wrong = right.replace("- 4 * q.a", "+ 4 * q.a"), slip = right.replace(/;(?=\n\})/, "");
const show = (what, value, budget = "") => console.log(`${what.padEnd(44)} ${value.padStart(18)}   ${budget}`.trimEnd());
const seconds = (milliseconds) => `${(milliseconds / 1000).toFixed(2)} s`;
const megabytes = (bytes) => `${(bytes / 1e6).toFixed(2)} MB`;
const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

/** The largest size of the browser's processes that hold a page, in bytes; memory that several share counts in part (PSS). */
function memoryOf(browser) {
    const parents = new Map(), commands = new Map();
    for (const pid of readdirSync("/proc").filter((name) => /^\d+$/.test(name)))
        try {
            parents.set(pid, /^PPid:\s*(\d+)/m.exec(readFileSync(`/proc/${pid}/status`, "utf8"))[1]);
            commands.set(pid, readFileSync(`/proc/${pid}/cmdline`, "utf8"));
        } catch { /* it has ended */ }
    const isOurs = (pid) => pid === String(browser.process().pid) || (parents.has(pid) && isOurs(parents.get(pid)));
    const sizes = [...parents.keys()].filter((pid) => isOurs(pid) && /type=renderer|contentproc/.test(commands.get(pid))).map((pid) => {
        try {
            return 1024 * Number(/^Pss:\s*(\d+)/m.exec(readFileSync(`/proc/${pid}/smaps_rollup`, "utf8"))[1]);
        } catch {
            return 0;
        }
    });
    return Math.max(...sizes);
}

const host = await serve(folder, { compress: true, rate: mbit * 1e6 }), browser = await launch();
/** The bytes that were sent until a moment of the page, a Date. */
const sentUntil = (moment, counts = () => true) => host.sent.log.reduce((sum, [when, bytes, path]) => when <= moment && counts(path) ? sum + bytes : sum, 0);
const isForVerdict = (path) => /\/(compiler|tree)\/|\/programs\/(judge|course)|\/pictures\.pack/.test(path);
const verdictIsThere = (tab) => tab.$eval("#verdict", (each) => each.dataset.result !== undefined && !each.classList.contains("old"));
try {
    const tab = await openTab(browser, host.address);
    const begin = Date.now();
    await tab.goto(`${host.address}${stem}.html`, { waitUntil: "domcontentloaded" });
    const started = await tab.evaluate(() => performance.timeOrigin);
    const paint = await waitFor("a paint", () => tab.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0]?.startTime));
    show(`first paint, ${mbit} Mbit/s`, seconds(paint), "at most 0.5 s");
    show("  sent until then", megabytes(sentUntil(started + paint)), "at most 0.1 MB");
    await waitFor("a live figure", () => tab.$(".figure.live"));
    const figure = Date.now();
    await tab.$eval("#judge", (each) => each.click());
    await waitFor("a verdict", () => verdictIsThere(tab));
    const first = Date.now();
    show("first live figure", seconds(figure - begin), "at most 2 s");
    show("  sent until then, without the compiler's", megabytes(sentUntil(figure, (path) => !isForVerdict(path))), "at most 1 MB");
    show("  of the compiler and the judge, already", megabytes(sentUntil(figure, isForVerdict)));
    show("first verdict", seconds(first - begin), "at most 8 s");
    show("  sent until then", megabytes(sentUntil(first)), "at most 8 MB");

    await waitFor("everything kept", () => tab.evaluate(async () => Boolean((await navigator.serviceWorker?.getRegistration())?.active)));
    host.stopSending();
    const before = host.sent.bytes, again = Date.now();
    await tab.reload({ waitUntil: "load" });
    await waitForEditor(tab);
    await tab.$eval("#judge", (each) => each.click());
    await waitFor("a verdict without a network", () => verdictIsThere(tab));
    show("first verdict of a later visit, no network", seconds(Date.now() - again));
    show("  sent", megabytes(host.sent.bytes - before), "0");

    /** From a key to the verdict, in the page's own clock. */
    const type = (text) => tab.$eval("#editor", new Function("place", "text", `return (async () => {
        const start = performance.now();
        (${replaceInEditor})(place, text, true);
        const until = async (isTrue) => { while (!isTrue()) await new Promise((resolve) => setTimeout(resolve, 2)); };
        await until(() => !document.querySelector("#verdict").classList.contains("old"));
        const took = performance.now() - start;
        await until(() => /judged/.test(document.querySelector("#state").textContent)); // and its pictures are drawn
        return took;
    })()`), text);
    for (const text of [right, wrong, slip, right, wrong, slip])
        await type(text);
    const times = { verdict: [], slip: [] };
    for (let i = 0; i < verdicts; i++) {
        times.verdict.push(await type(`${i % 2 ? right : wrong}// ${i}\n`));
        times.slip.push(await type(`${slip}// ${i}\n`));
    }
    if (!(await editorText(tab)).includes(`// ${verdicts - 1}`))
        throw new Error("the editor has another text than was typed");
    show("from a key to the verdict, median", `${median(times.verdict).toFixed(0)} ms`, "at most 250 ms");
    show("  a missing semicolon", `${median(times.slip).toFixed(0)} ms`, "at most 150 ms");

    // ---- what is dragged: a sphere of the scene beside the exercise, and a handle of each figure ------------------------
    const DRAGGED = 2000; // milliseconds
    /** Moves a handle round as fast as frames come, and counts what is drawn; then how long the fine picture takes. */
    const drag = (page, find) => page.evaluate(new Function("given", `return (async () => {
        const [find, DRAGGED] = given, { handle, drawn, isFine } = eval(find), box = handle.getBoundingClientRect();
        const send = (kind, x, y) => handle.dispatchEvent(new PointerEvent(kind, { pointerId: 1, clientX: box.x + box.width / 2 + x, clientY: box.y + box.height / 2 + y, bubbles: true }));
        handle.setPointerCapture = () => {};
        handle.hasPointerCapture = () => true;
        send("pointerdown", 0, 0);
        const counted = drawn(), start = performance.now();
        for (let i = 0; performance.now() - start < DRAGGED; i++) {
            send("pointermove", 12 * Math.cos(i / 9), 12 * Math.sin(i / 9));
            await new Promise(requestAnimationFrame);
        }
        const frames = counted() / (performance.now() - start) * 1000, end = performance.now();
        send("pointerup", 0, 0);
        while (isFine && !isFine())
            await new Promise(requestAnimationFrame);
        return { frames, fine: performance.now() - end };
    })()`), [find, DRAGGED]);
    const scene = `(() => {
        const canvas = document.querySelector(".stage canvas"), context = canvas.getContext("2d"), drawImage = context.drawImage;
        return { handle: document.querySelector('.handles button[data-kind="s"]'), isFine: () => canvas.hasAttribute("data-fine"),
            drawn() { let count = 0; context.drawImage = (...all) => { count++; drawImage.apply(context, all); }; return () => count; } };
    })()`;
    await waitFor("the scene", () => tab.$(".stage canvas[data-fine]"));
    await drag(tab, scene); // the engine makes its code faster meanwhile
    const { frames, fine } = await drag(tab, scene);
    show("three spheres with mirrors, dragged", `${frames.toFixed(1)} frames/s`, "at least 30 frames/s");
    show("  the whole picture after that", seconds(fine), "at most 0.3 s");
    show("memory of the tab, after all that", megabytes(memoryOf(browser)));
    await new Promise((resolve) => setTimeout(resolve, 15000));
    show("  when what is not used any more is freed", megabytes(memoryOf(browser)), "at most 400 MB");
    for (const each of ["05-quadratic", "06-ray-casting"]) {
        await tab.goto(`${host.address}${each}.html`, { waitUntil: "load" }).catch(() => {});
        await waitFor("the judge, which takes time from figures", () => tab.evaluate(() => globalThis.judgeIsReady));
        for (const name of await tab.$$eval(".lesson .figure", (all) => [...new Set(all.map((one) => one.dataset.figure))])) {
            const at = `document.querySelector('.figure[data-figure="${name}"]')`;
            const isLive = await waitFor(`${name} live`, () => tab.evaluate(`${at}.closest("details")?.setAttribute("open", ""), ${at}.scrollIntoView({ block: "center" }),
                ${at}.querySelector(".drawing > div")?.shadowRoot?.querySelector("svg") ? 1 + ${at}.querySelector(".drawing > div").shadowRoot.querySelectorAll(".handle:not([hidden])").length : 0`));
            if (isLive < 2)
                continue; // nothing of it is dragged
            const figure = `(() => {
                const root = ${at}.querySelector(".drawing > div").shadowRoot, count = { value: 0 };
                new MutationObserver(() => { count.value++; }).observe(root.querySelector(".drawing"), { childList: true });
                return { handle: root.querySelector(".handle:not([hidden])"), drawn() { const before = count.value; return () => count.value - before; } };
            })()`;
            await drag(tab, figure);
            show(`${name}, dragged`, `${(await drag(tab, figure)).frames.toFixed(1)} frames/s`, "at least 20 frames/s");
        }
    }
    for (const fault of tab.faults)
        show("fault", fault);
    console.log(`${await browser.version()}, ${verdicts} verdicts of each kind`);
} finally {
    await browser.close();
    await host.stop();
}
