// lecture.mjs - the lecture in a real browser: its keys, its addresses, a figure that is dragged, the speaker's window, and the
// page as a file.
//
// Usage: BROWSER=chromium|firefox node lecture.mjs SITE
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import test from "node:test";
import { withCodes } from "../../../../chapters/book/site/lecture.mjs";
import { begin, seriousFindings, waitFor } from "../site.mjs";

const { folder, browser, openPage } = await begin();
const html = readFileSync(join(folder, "lecture.html"), "utf8");

async function open(address = "") {
    const tab = await openPage(`lecture.html${address}`, { width: 1280, height: 720 });
    await isReady(tab);
    return tab;
}
const isReady = (tab) => waitFor("the slides", () => tab.evaluate(() => document.documentElement.classList.contains("ready")));
const shown = (tab) => tab.evaluate(() => {
    const page = document.querySelector(".slide.shown");
    return { address: location.hash, number: page.dataset.slide, words: [...page.querySelectorAll("p")].filter((each) => getComputedStyle(each).visibility === "visible").map((each) => each.innerText).join("\n") };
});
/** A test in a tab of its own, which shows this slide first. */
const onSlide = (name, address, does) => test(name, async () => {
    const tab = await open(address);
    await does(tab);
    await tab.close();
});
async function press(tab, ...keys) {
    for (const key of keys)
        await tab.keyboard.press(key);
    return shown(tab);
}

onSlide("keys and a clicker go from step to step", "#camera-frame", async (tab) => {
    assert.equal((await press(tab, "PageDown")).address, "#camera-frame/2");
    assert.equal((await press(tab, "ArrowRight", "Space")).address, "#double-dwh");
    assert.equal((await press(tab, "ArrowLeft", "PageUp")).address, "#camera-frame/2");
    assert.equal((await press(tab, "Home")).number, "1");
});

onSlide("a question is shown before its answer", "#double-dwh", async (tab) => {
    assert.match((await shown(tab)).words, /Would it matter/);
    assert.doesNotMatch((await shown(tab)).words, /No: every vector/);
    assert.match((await press(tab, "ArrowRight")).words, /No: every vector/);
});

test("each part ends with a question to the class, whose answer is not among its first words", async () => {
    const parts = [...new Set([...html.matchAll(/<span>([^<]*) · \d+ of \d+</g)].map(([, part]) => part))].slice(1);
    const asked = [...html.matchAll(/<section [^>]*id="((?:ask|vote)-[^"/]*)"[^]*?<span>([^<]*) · [^<]*</g)];
    assert.deepEqual([...new Set(asked.map(([, , part]) => part))], parts);
    const tab = await open(`#${asked[0][1]}`);
    const before = (await shown(tab)).words;
    assert.match(before, /By which\?\nA .*\nB .*\nC .*\nD /);
    assert.doesNotMatch(before, /It was/);
    assert.match((await press(tab, "ArrowRight")).words, /It was [A-D]: .*\nRight is [A-D]\./);
    assert.ok(await tab.$$eval(".shown .picture img", (images) => images.length === 2 && images.every((each) => each.complete && each.naturalWidth > 0)));
    await tab.close();
});

test("a slide's code is for the address of the site, and large by a key", async () => {
    const slide = '<h2>A</h2><a class="qr" href="figures.html#parabola"></a>';
    assert.equal(withCodes(slide, ""), "<h2>A</h2>");
    const codes = ["https://example.org/a/", "https://example.org/b/"].map((address) => withCodes(slide, address));
    assert.match(codes[0], /<h2>A<\/h2><a class="qr" href="figures.html#parabola" [^>]*><svg /);
    assert.notEqual(codes[0], codes[1]);
    const tab = await open("#parabola");
    await tab.evaluate((code) => document.querySelector(".shown h2").insertAdjacentHTML("afterend", code), codes[0].slice("<h2>A</h2>".length));
    const width = () => tab.$eval(".shown .qr svg", (code) => code.getBoundingClientRect().width);
    const small = await width();
    await press(tab, "q");
    assert.ok(await width() > 5 * small);
    await press(tab, "ArrowRight", "ArrowLeft");
    assert.equal(await width(), small);
    await tab.close();
});

onSlide("a number and a name lead to their slide", "", async (tab) => {
    await press(tab, "g");
    await tab.keyboard.type("9");
    assert.equal((await press(tab, "Enter")).number, "9");
    await press(tab, "g");
    await tab.keyboard.type("parabola");
    assert.equal((await press(tab, "Enter")).address, "#parabola");
});

onSlide("a black screen hides the slide, and the next key shows it again", "#parabola", async (tab) => {
    const isBlack = () => tab.$eval("#black", (each) => !each.hidden);
    await press(tab, "b");
    assert.ok(await isBlack());
    assert.equal((await press(tab, "ArrowRight")).address, "#parabola");
    assert.ok(!await isBlack());
});

onSlide("no words leave their slide", "", async (tab) => {
    const outside = await tab.evaluate(() => [...document.querySelectorAll(".slide")].filter((page) => {
        const footer = page.querySelector("footer").getBoundingClientRect();
        return [...page.querySelectorAll(".words p")].some((each) => each.getBoundingClientRect().bottom > footer.top + 3);
    }).map((page) => page.id));
    assert.deepEqual(outside, []);
});

onSlide("a figure is dragged, and stays so on the next step", "#ray-sphere", async (tab) => {
    const state = () => tab.evaluate(() => {
        const root = document.querySelector(".shown .drawing > div")?.shadowRoot, box = root?.querySelector(".handle")?.getBoundingClientRect();
        return box && document.querySelector(".shown .drawing").ariaBusy !== "true" && { value: root.querySelector("input[name=origin]").value, x: box.x + box.width / 2, y: box.y + box.height / 2 };
    });
    const before = await waitFor("the live figure", state);
    await tab.mouse.move(before.x, before.y);
    await tab.mouse.down();
    await tab.mouse.move(before.x + 30, before.y - 40, { steps: 5 });
    await tab.mouse.up();
    const after = await waitFor("another origin", async () => { const now = await state(); return now && now.value !== before.value && now; });
    await press(tab, "PageDown");
    await waitFor("the same figure", async () => (await state())?.value === after.value);
});

onSlide("a student's line is judged and drawn", "#screen-to-unit", async (tab) => {
    const judged = async (words, wanted) => {
        await tab.$eval("#line textarea", (each, text) => { each.value = text; }, words);
        await tab.click("#judge-line");
        return waitFor(wanted, () => tab.$eval("#line output", (each, text) => each.innerText.includes(text) && each.innerText, wanted));
    };
    await press(tab, "p");
    assert.equal(await waitFor("the slide's function", () => tab.$eval("#line select", (each) => each.selectedOptions[0]?.text)), "Normalized screen_to_normalized(ScreenPoint point, Resolution screen)");
    assert.match(await judged("{point.x / screen.width, point.y / screen.height}", "✗"), /counts down from the top[^]*expected\s+\(/i);
    await waitFor("its figure", () => tab.$eval("#line output", (each) => each.querySelector("img")?.naturalWidth > 0));
    assert.match(await judged("return (Normalized){point.x / width, 0};", "Not judged"), /width/);
    await judged("double y = point.y / screen.height;\nreturn (Normalized){point.x / screen.width, 1 - y};", "✓ Right");
});

onSlide("the speaker's window follows, and leads", "#camera-frame", async (tab) => {
    const [page] = await Promise.all([new Promise((done) => tab.once("popup", done)), tab.keyboard.press("s")]);
    await isReady(page);
    const notes = () => page.$eval("#speaker", (each) => each.innerText);
    await waitFor("its notes", async () => /left-handed/.test(await notes()));
    assert.match(await notes(), /4 min|3 min/);
    await page.keyboard.press("PageDown");
    await waitFor("the slides follow", async () => (await shown(tab)).address === "#camera-frame/2");
    await press(tab, "PageDown");
    await waitFor("the window follows", async () => (await shown(page)).address === "#camera-frame/3");
    await page.close();
});

test("it works as a file", async () => {
    const tab = await browser.newPage();
    await tab.goto(`file://${resolve(folder, "lecture.html")}#corner-vectors`);
    await isReady(tab);
    assert.equal((await press(tab, "PageDown")).address, "#corner-vectors/2");
    assert.ok(await tab.$eval(".shown .drawing img", (each) => each.complete && each.naturalWidth > 0));
    await tab.close();
});

onSlide("everybody can use it", "#parabola", async (tab) => {
    assert.deepEqual(await seriousFindings(tab), []);
});
