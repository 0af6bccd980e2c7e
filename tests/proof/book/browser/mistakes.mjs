// mistakes.mjs - the gallery of known mistakes: closed until a chapter is done, then each question has a picture that is wrong,
// and another than those of the other lines.
//
// Usage: BROWSER=chromium|firefox node mistakes.mjs SITE [FOLDER-FOR-SCREENSHOTS]
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { begin, hasVerdict, replaceText, seriousFindings, waitFor } from "../site.mjs";

const { openPage } = await begin();
const tab = await openPage("mistakes.html#05-quadratic", { width: 1440, height: 900 });
const stem = "05-quadratic", stems = await tab.$$eval(".chapters li", (all) => all.map((each) => each.dataset.stem));
const right = (name) => readFileSync(join("solutions", `${name}.c`), "utf8");
const isOpen = () => tab.$eval("#question", (each) => !each.hidden);

/** The pixels of the picture, as soon as it is fine. */
async function picture() {
    await waitFor("a picture", () => tab.$("#question canvas[data-fine]"));
    return tab.$eval("#question canvas", (canvas) => canvas.toDataURL());
}
/** Chooses line after line until the right one is found; it and the others, as they are in the page. */
async function guess() {
    const count = (await tab.$$("#choices button")).length, choose = (number) => tab.press(`#choices li:nth-child(${number}) button`);
    for (let number = 1; number <= count; number++) {
        await choose(number);
        if (await tab.$("#choices .found"))
            return { choose, count, found: number };
        assert.match(await tab.text(`#choices li:nth-child(${number}) p`), /^Not this one. It would show: /);
    }
    return assert.fail("no line was right");
}

test("the gallery of known mistakes", async (t) => {
    await t.test("before the chapter is done the page says what is missing, and shows nothing", async () => {
        await waitFor("the missing functions", async () => /^Not open yet. 05.* still needs: to_object_coordinates, .*hit_sphere\.$/.test(await tab.text("#closed")));
        assert.equal(await isOpen(), false);
        assert.equal(await tab.text("#choices"), "");
        await tab.shot("mistakes-closed");
    });
    await t.test("the verdict of a chapter that is done leads to it", async () => {
        await tab.visit(`${stem}.html`);
        await replaceText(tab, right(stem), { judge: true });
        await waitFor("a right answer", () => hasVerdict(tab, /Look at what can go wrong/));
        await tab.press("#way-on .button");
        await waitFor("the gallery", () => isOpen().catch(() => false));
    });
    await t.test("a picture is that of its mistake", async () => {
        const shown = await picture(), { found } = await guess(), formula = await tab.text(`#choices li:nth-child(${found}) code`), name = await tab.text("#asked code");
        const program = "build/tests/mistaken/06-ray-casting", listed = execFileSync(program, ["list"], { encoding: "utf8" }).split("\n").map((line) => line.split("\t"));
        const file = join(process.env.TMPDIR ?? "/tmp", `mistake-${process.pid}.png`), number = listed.findIndex((each) => each[1] === name && each[3] === formula);
        execFileSync(program, [String(number), "-s", "480x360", "-o", file]);
        const differing = await tab.evaluate(async (...urls) => {
            const pixels = await Promise.all(urls.map(async (src) => {
                const image = Object.assign(new Image(), { src }), canvas = new OffscreenCanvas(480, 360).getContext("2d");
                await image.decode();
                canvas.drawImage(image, 0, 0);
                return canvas.getImageData(0, 0, 480, 360).data;
            }));
            return pixels[0].filter((each, at) => each !== pixels[1][at]).length;
        }, shown, `data:image/png;base64,${readFileSync(file, "base64")}`);
        assert.equal(differing, 0, "bytes of the picture that differ");
        await tab.shot("mistakes-found");
        assert.deepEqual(await seriousFindings(tab), []);
        await tab.setViewport({ width: 390, height: 844 });
        assert.ok(await tab.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "it is not wider than a phone");
        await tab.shot("mistakes-found-390");
        await tab.setViewport({ width: 1440, height: 900 });
    });
    await t.test("a key turns it", async () => {
        const before = await picture();
        await tab.focus("#question canvas");
        await tab.keyboard.press("ArrowLeft");
        await waitFor("another picture", async () => await picture() !== before);
    });
    await t.test("in each chapter, each question can be answered by its picture", async () => {
        for (const each of stems.filter((other) => other !== stem)) {
            await tab.visit(`${each}.html`);
            await replaceText(tab, right(each), { judge: true });
            await waitFor("a right answer", () => hasVerdict(tab, /Look at what can go wrong/));
        }
        for (const each of stems) {
            await tab.visit(`mistakes.html#${each}`);
            await waitFor("the gallery", isOpen);
            for (let isLast = false; !isLast;) {
                const what = `${await tab.text("#asked")} ${await tab.text("#of")}`, wrong = await picture();
                await tab.press("#compare");
                assert.notEqual(await picture(), wrong, `${what} The picture is right.`);
                const { choose, count, found } = await guess();
                assert.deepEqual(await tab.$$eval("#choices p", (all) => all.map((each) => each.textContent).filter((words) => /(^|\. )a (?!is )[a-z]{2}/.test(words))), [], "a sentence has a capital");
                for (let number = 1; number <= count; number++) {
                    await choose(number);
                    if (number === found)
                        assert.equal(await picture(), wrong, what);
                    else
                        assert.notEqual(await picture(), wrong, `${what} Line ${number} has the same picture.`);
                }
                isLast = await tab.$eval("#next", (button) => button.disabled);
                await tab.press("#next");
            }
            await tab.shot(`mistakes-${each}`);
        }
    });
    await t.test("nothing went wrong in the page", () => assert.deepEqual(tab.faults, []));
});
