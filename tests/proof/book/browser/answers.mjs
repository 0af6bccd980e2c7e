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

const scratch = mkdtempSync(join(tmpdir(), "book-"));
const { host, browser, openPage } = await begin();
/** The bytes of the file that a button saves, read where the page makes it. */
async function downloaded(tab, button) {
    await tab.evaluate(() => {
        globalThis.makeAddress ??= URL.createObjectURL;
        globalThis.saved = null;
        URL.createObjectURL = (blob) => { globalThis.saved = blob.arrayBuffer().then((all) => [...new Uint8Array(all)]); return globalThis.makeAddress.call(URL, blob); };
    });
    await tab.press(button);
    await waitFor("a file", () => tab.evaluate(() => globalThis.saved !== null));
    return Uint8Array.from(await tab.evaluate(() => globalThis.saved));
}
test("a student's answer", async (t) => {
    const tab = await openPage("03-screen.html");
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
        await tab.press("#reset");
        assert.equal(await editorText(tab), blank);
        await tab.reload({ waitUntil: "load" });
        await waitForEditor(tab);
        await waitFor("a way back", () => tab.$eval("#undo-reset", (each) => !each.hidden));
        await tab.press("#undo-reset");
        assert.equal(await editorText(tab), mine);
    });
    await t.test("two tabs show the same text", async () => {
        const other = await openPage("03-screen.html");
        await typeAtEnd(other, "// from the other tab");
        await waitFor("the text of the other tab", async () => (await editorText(tab)).includes("// from the other tab"));
        await other.close();
    });
    await t.test("the contract is one key away", async () => {
        await tab.focus("#tab-answer");
        await tab.keyboard.press("ArrowRight");
        assert.equal(await tab.$eval("#panel-contract", (each) => each.hidden), false);
        assert.match(await tab.text("#panel-contract"), /03-screen.h/);
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

    const start = await openPage("index.html");
    await t.test("the start page says what is begun", async () => {
        await waitFor("'begun'", async () => /begun|right/.test(await start.text('.cards li[data-stem="03-screen"] .done')));
        assert.match(await start.text("#begin"), /^Continue with chapter/);
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
        await waitFor("'Loaded 03'", async () => /Loaded 03/.test(await start.text("#state")));
        assert.ok(await start.evaluate((text) => Object.values(localStorage).includes(text), mine));
    });
    await t.test("answers that are loaded are judged, and the start page counts what is right", async () => {
        await (await start.$("#upload")).uploadFile("solutions/03-screen.c", "solutions/04-pixel-ray.c");
        await waitFor("all to be judged", async () => /^Loaded 03, 04. Open a chapter/.test(await start.text("#state")));
        assert.match(await start.text("#so-far"), /^4 of 37 functions are right\.$/);
        assert.match(await start.text('.cards li[data-stem="04-pixel-ray"] .done'), /done/);
        await waitFor("the picture by these", async () => /^Yours, 4 of 37 functions: .*pixel_ray\. By the reference: the others\.$/.test(await start.text("#picture .credit")));
    });
    await t.test("what is no archive changes nothing, and the page says so", async () => {
        writeFileSync(join(scratch, "photo.zip"), "not an archive at all, but long enough");
        await (await start.$("#upload")).uploadFile(join(scratch, "photo.zip"));
        await waitFor("the words", async () => /not a zip archive.*Nothing has changed/.test(await start.text("#trouble")));
    });
    await start.close();

    await t.test("a browser that keeps nothing says so, and the download of what was typed is beside these words", async () => {
        const poor = await openTab(browser, host.address), asked = [];
        await poor.evaluateOnNewDocument(() => { Storage.prototype.setItem = () => { throw new DOMException("no", "SecurityError"); }; });
        poor.on("dialog", async (dialog) => { asked.push(dialog.type()); await dialog.accept(); });
        await poor.visit("04-pixel-ray.html");
        await typeAtEnd(poor, "// lost soon");
        await waitFor("the warning", async () => /does not save your answers/.test(await poor.text("#unsaved")));
        await waitFor("a verdict", async () => /not saved/.test(await poor.text("#state")));
        assert.equal(await poor.$eval("#unsaved", (each) => each.hidden), false, "a verdict does not take the warning away");
        const files = await readZip(await downloaded(poor, "#unsaved button"));
        assert.match(new TextDecoder().decode(files.find(({ name }) => name === "04-pixel-ray.c").bytes), /\/\/ lost soon/);
        await typeAtEnd(poor, "// lost");
        await poor.visit("index.html");
        assert.deepEqual(asked, ["beforeunload"], "the browser asks before what was not downloaded is lost");
        await poor.close();
    });
    await t.test("a figure fills the screen, the arrows go on, Escape comes back", async () => {
        const figures = await openPage("figures.html");
        await waitFor("a button", () => figures.$("figcaption button"));
        await figures.press("figcaption button");
        const status = () => figures.text("dialog.full [role=status]");
        const first = await waitFor("a figure", status);
        await waitFor("what can be dragged, and fields", () => figures.evaluate(() => {
            const root = document.querySelector("dialog.full .drawing > div")?.shadowRoot;
            return root?.querySelector(".handle:not([hidden])") && root.querySelector("input");
        }));
        await waitFor("another step or figure", async () => { await figures.keyboard.press("ArrowRight"); return await status() !== first; });
        await figures.keyboard.press("Escape");
        await waitFor("the page again", () => figures.$eval("dialog.full", (each) => !each.open && !each.querySelector(".drawing")));
        assert.equal(await figures.$$eval(".figure", (all) => all.filter((each) => !each.querySelector(".drawing")).length), 0);
        await figures.close();
    });
});
test.after(() => rmSync(scratch, { recursive: true, force: true }));
