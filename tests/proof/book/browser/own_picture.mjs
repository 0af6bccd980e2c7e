// own_picture.mjs - the start page's picture is cast in the page: by the reference, from the first right answer on by the
// student's functions, at the end by nothing else; it turns by key.
//
// Usage: BROWSER=chromium|firefox node own_picture.mjs SITE [FOLDER-FOR-SCREENSHOTS]
import assert from "node:assert/strict";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { makeZip } from "../../../../chapters/book/page/answers.js";
import { begin, waitFor } from "../site.mjs";

const { openPage } = await begin();
const tab = await openPage("index.html", { width: 1440, height: 900 });
const solutions = readdirSync("solutions").filter((name) => /^\d\d-.*\.c$/.test(name)).sort();
/** The picture is complete, and these words are below it: both at once. */
const fine = (what, words) => waitFor(what, async () => words.test(await tab.$eval("#picture", (each) =>
    each.querySelector("canvas[data-fine]") ? each.querySelector(".credit").textContent : "").catch(() => "")));
/** The picture's colors, in 16 x 9 parts. */
const colors = () => tab.$eval("#picture canvas", (canvas) => {
    const small = Object.assign(document.createElement("canvas"), { width: 16, height: 9 }).getContext("2d");
    small.drawImage(canvas, 0, 0, 16, 9);
    return [...small.getImageData(0, 0, 16, 9).data];
});
const apart = (a, b) => Math.max(...a.map((each, at) => Math.abs(each - b[at])));

/** An archive of answers, as a student uploads it. */
async function upload(texts) {
    const path = join(process.env.TMPDIR ?? "/tmp", `own-picture-${process.pid}.zip`);
    writeFileSync(path, await makeZip(Object.entries(texts).map(([name, text]) => ({ name, bytes: new TextEncoder().encode(text) }))));
    await (await tab.$("#upload")).uploadFile(path);
}
const right = (name) => readFileSync(join("solutions", name), "utf8");

test("the picture of the start page", async (t) => {
    let before;
    await t.test("the reference casts it", async () => {
        await fine("a picture by the reference", /by the reference/);
        before = await colors();
        await tab.shot("own-picture-reference");
    });
    await t.test("a key turns it, and the picture is fine again", async () => {
        await tab.focus("#picture canvas");
        await tab.keyboard.press("ArrowLeft");
        await waitFor("another picture", async () => await tab.$("#picture canvas[data-fine]") && apart(before, await colors()) > 8);
        await tab.keyboard.press("ArrowRight");
        await waitFor("the first picture", async () => await tab.$("#picture canvas[data-fine]") && apart(before, await colors()) <= 2);
    });
    await t.test("right answers draw it, and are named; a wrong one does not", async () => {
        await upload({ "02-cameras.c": right("02-cameras.c"), "01-corners.c": right("01-corners.c").replace(/return [^;]*w[^;]*;/, "return c.up;") });
        await fine("a picture with some answers", /^Yours, \d+ of \d+ functions: .*camera_from/);
        await tab.shot("own-picture-some");
        assert.ok(apart(before, await colors()) <= 2);
    });
    await t.test("all answers: drawn by the student's own code, to be saved", async () => {
        await upload(Object.fromEntries(solutions.map((name) => [name, right(name)])));
        await fine("a picture by all answers", /^Drawn by your own code/);
        await tab.shot("own-picture-all");
        assert.equal(await tab.$eval("#picture button", (each) => each.hidden), false);
        const after = await colors();
        assert.ok(apart(before, after) <= 2, `the parts differ by ${apart(before, after)}`);
    });
    await t.test("nothing went wrong in the page", () => assert.deepEqual(tab.faults, []));
});
