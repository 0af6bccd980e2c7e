// answers.mjs - a student's answer in a real browser: typed, saved, reset and back, in two tabs, without storage, downloaded
// and uploaded again.
//
// Usage: BROWSER=chromium|firefox node answers.mjs SITE
import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { readZip } from "../../../../chapters/book/page/answers.js";
import { begin, editorText, openTab, typeAtEnd, waitFor, waitForEditor } from "../site.mjs";

const [folder] = process.argv.slice(2);
const scratch = mkdtempSync(join(tmpdir(), "book-"));
const { host, browser } = await begin(folder);
const open = async (name) => {
    const tab = await openTab(browser, host.address);
    await tab.goto(host.address + name, { waitUntil: "load" });
    if (name !== "index.html")
        await waitForEditor(tab);
    return tab;
};
/** The bytes of the file that a button saves, read where the page makes it. */
async function downloaded(tab, button) {
    await tab.evaluate(() => {
        globalThis.makeAddress ??= URL.createObjectURL;
        globalThis.saved = null;
        URL.createObjectURL = (blob) => { globalThis.saved = blob.arrayBuffer().then((all) => [...new Uint8Array(all)]); return globalThis.makeAddress.call(URL, blob); };
    });
    await click(tab, button);
    await waitFor("a file", () => tab.evaluate(() => globalThis.saved !== null));
    return Uint8Array.from(await tab.evaluate(() => globalThis.saved));
}
const click = (tab, selector) => tab.$eval(selector, (each) => each.click());
const textOf = (tab, selector) => tab.$eval(selector, (each) => each.textContent);
test("a student's answer", async (t) => {
    const tab = await open("03-screen.html");
    const blank = await editorText(tab);
    await t.test("the blank is there, and what is typed is saved at once", async () => {
        assert.match(blank, /NOT_ANSWERED/);
        await typeAtEnd(tab, "// mine");
        await tab.reload({ waitUntil: "load" });
        await waitFor("the saved text", async () => (await editorText(tab).catch(() => "")).includes("// mine"));
    });
    await t.test("Tab indents; Escape and then Tab leaves the editor", async () => {
        await typeAtEnd(tab, "\t");
        assert.match(await editorText(tab), /^ {4}\/\/ mine$/m);
        await tab.keyboard.press("Escape");
        await tab.keyboard.press("Tab");
        assert.notEqual(await tab.evaluate(() => document.activeElement.id), "editor");
    });
    await t.test("a reset can be undone", async () => {
        const mine = await editorText(tab);
        await click(tab, "#reset");
        assert.equal(await editorText(tab), blank);
        await tab.reload({ waitUntil: "load" });
        await waitForEditor(tab);
        await waitFor("a way back", () => tab.$eval("#undo-reset", (each) => !each.hidden));
        await click(tab, "#undo-reset");
        assert.equal(await editorText(tab), mine);
    });
    await t.test("two tabs show the same text", async () => {
        const other = await open("03-screen.html");
        await typeAtEnd(other, "// from the other tab");
        await waitFor("the text of the other tab", async () => (await editorText(tab)).includes("// from the other tab"));
        await other.close();
    });
    await t.test("the contract is one key away", async () => {
        await tab.focus("#tab-answer");
        await tab.keyboard.press("ArrowRight");
        assert.equal(await tab.$eval("#panel-contract", (each) => each.hidden), false);
        assert.match(await textOf(tab, "#panel-contract"), /03-screen.h/);
        await tab.keyboard.press("ArrowLeft");
    });
    await t.test("a function of the contract is completed, with its comment; a bracket is closed", async () => {
        await typeAtEnd(tab, "pixel_c");
        const shown = (selector) => tab.$eval("#editor", (place, wanted) => place.shadowRoot.querySelector(wanted)?.textContent ?? "", selector);
        await waitFor("the function", async () => /pixel_center/.test(await shown(".cm-tooltip-autocomplete")));
        await waitFor("its comment", async () => (await shown(".cm-completionInfo")).length > 20);
        await tab.keyboard.press("Escape");
        await tab.keyboard.press("(");
        assert.match(await editorText(tab), /pixel_c\(\)$/);
        await typeAtEnd(tab, "//");
    });
    const mine = await tab.evaluate(() => Object.entries(localStorage).find(([name]) => name.endsWith("03-screen answer"))[1]);
    await tab.close();

    const start = await open("index.html");
    await t.test("the start page says what is begun", async () => {
        await waitFor("'begun'", async () => /begun|right/.test(await textOf(start, '.cards li[data-stem="03-screen"] .done')));
        assert.match(await textOf(start, "#begin"), /^Continue with chapter/);
    });
    let zip;
    await t.test("the archive has the answer as it is", async () => {
        zip = await downloaded(start, "#download");
        const files = await readZip(zip);
        assert.deepEqual(files.map(({ name }) => name), ["03-screen.c"]);
        assert.equal(new TextDecoder().decode(files[0].bytes), mine);
    });
    await t.test("another browser goes on from the archive", async () => {
        writeFileSync(join(scratch, "submission.zip"), zip);
        await start.evaluate(() => localStorage.clear());
        await start.reload({ waitUntil: "load" });
        await waitFor("the page", () => start.$eval("#theme", (each) => each.title !== ""));
        const input = await start.$("#upload");
        await input.uploadFile(join(scratch, "submission.zip"));
        await waitFor("'Loaded 03'", async () => /Loaded 03/.test(await textOf(start, "#state")));
        assert.ok(await start.evaluate((text) => Object.values(localStorage).includes(text), mine));
    });
    await t.test("answers that are loaded are judged, and the start page counts what is right", async () => {
        await (await start.$("#upload")).uploadFile("solutions/03-screen.c", "solutions/04-pixel-ray.c");
        await waitFor("all to be judged", async () => /^Loaded 03, 04. Open a chapter/.test(await textOf(start, "#state")));
        assert.match(await textOf(start, "#so-far"), /^4 of 37 functions are right\.$/);
        assert.match(await textOf(start, '.cards li[data-stem="04-pixel-ray"] .done'), /done/);
        await waitFor("the picture by these", async () => /^Yours, 4 of 37 functions: .*pixel_ray\. By the reference: the others\.$/.test(await textOf(start, "#picture .credit")));
    });
    await t.test("what is no archive changes nothing, and the page says so", async () => {
        writeFileSync(join(scratch, "photo.zip"), "not an archive at all, but long enough");
        await (await start.$("#upload")).uploadFile(join(scratch, "photo.zip"));
        await waitFor("the words", async () => /not a zip archive.*Nothing has changed/.test(await textOf(start, "#trouble")));
    });
    await start.close();

    await t.test("a browser that keeps nothing says so, and the download of what was typed is beside these words", async () => {
        const poor = await openTab(browser, host.address), asked = [];
        await poor.evaluateOnNewDocument(() => { Storage.prototype.setItem = () => { throw new DOMException("no", "SecurityError"); }; });
        poor.on("dialog", async (dialog) => { asked.push(dialog.type()); await dialog.accept(); });
        await poor.goto(`${host.address}04-pixel-ray.html`, { waitUntil: "load" });
        await waitForEditor(poor);
        await typeAtEnd(poor, "// lost soon");
        await waitFor("the warning", async () => /does not save your answers/.test(await textOf(poor, "#unsaved")));
        await waitFor("a verdict", async () => /not saved/.test(await textOf(poor, "#state")));
        assert.equal(await poor.$eval("#unsaved", (each) => each.hidden), false, "a verdict does not take the warning away");
        const files = await readZip(await downloaded(poor, "#unsaved button"));
        assert.match(new TextDecoder().decode(files.find(({ name }) => name === "04-pixel-ray.c").bytes), /\/\/ lost soon/);
        await typeAtEnd(poor, "// lost");
        await poor.goto(`${host.address}index.html`, { waitUntil: "load" });
        assert.deepEqual(asked, ["beforeunload"], "the browser asks before what was not downloaded is lost");
        await poor.close();
    });
    await t.test("a figure fills the screen, the arrows go on, Escape comes back", async () => {
        const figures = await openTab(browser, host.address);
        await figures.goto(`${host.address}figures.html`, { waitUntil: "load" });
        await waitFor("a button", () => figures.$("figcaption button"));
        await click(figures, "figcaption button");
        const status = () => textOf(figures, "dialog.full [role=status]");
        const first = await waitFor("a figure", status);
        await waitFor("another step or figure", async () => { await figures.keyboard.press("ArrowRight"); return await status() !== first; });
        await figures.keyboard.press("Escape");
        await waitFor("the page again", () => figures.$eval("dialog.full", (each) => !each.open));
        await figures.close();
    });
});
test.after(() => rmSync(scratch, { recursive: true, force: true }));
