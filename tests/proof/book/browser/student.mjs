// student.mjs - chapters done in a page as a student does them: a blank, a missing semicolon, a known mistake with its
// figure, a hint, the right answer with its picture, progress; then the same without a network.
//
// Usage: BROWSER=chromium|firefox CHAPTERS=01,04,05 node student.mjs SITE [FOLDER-FOR-SCREENSHOTS]
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import test from "node:test";
import { begin, FOR_A_TERMINAL, hasVerdict, replaceText, waitFor } from "../site.mjs";

const chapters = (process.env.CHAPTERS ?? "01,04,05").split(",");
const stems = readdirSync("solutions").filter((name) => /^\d\d-.*\.c$/.test(name) && chapters.includes(name.slice(0, 2))).map((name) => name.slice(0, -2)).sort();
const { host, openPage } = await begin();
const tab = await openPage("index.html");
const write = (text) => replaceText(tab, text, { judge: true });
const verdict = (what, wanted) => waitFor(`the verdict: ${what}`, async () => {
    assert.equal(await tab.text("#trouble"), "", what);
    return hasVerdict(tab, wanted);
});

/** From the top of a page to its editor without a mouse, and a verdict. */
async function judgeByKeyboard() {
    const reach = async (what, isThere) => {
        for (let presses = 0; presses < 40; presses++) {
            await tab.keyboard.press("Tab");
            if (await tab.evaluate(isThere))
                return;
        }
        throw new Error(`40 presses of Tab do not reach ${what}`);
    };
    await reach("the link to the exercise", () => document.activeElement.getAttribute("href") === "#exercise");
    await tab.keyboard.press("Enter");
    await reach("the editor", () => document.activeElement.id === "editor");
    await tab.keyboard.down("Control");
    await tab.keyboard.press("Enter");
    await tab.keyboard.up("Control");
}

test("chapters done as a student does them", async () => {
    for (const stem of stems) {
        const right = readFileSync(`solutions/${stem}.c`, "utf8");
        await tab.visit(`${stem}.html`);
        if (stem === stems[0])
            await judgeByKeyboard();
        else
            await tab.press("#judge");
        await verdict(`${stem} is blank`, /not answered yet/);
        await tab.press("#hint");
        await waitFor("a hint", async () => (await tab.text("#hints")).length > 20);
        await tab.press("#hint");
        await waitFor("the next hint", () => tab.$$eval("#hints li", (all) => all.length === 2 && /hint 1 of.*hint 2 of/s.test(all.map((each) => each.textContent).join())));
        await write(right.replace(/;\n\s*\/\/ END SOLUTION/, "\n    // END SOLUTION"));
        await verdict(`${stem} lacks a semicolon`, /does not compile/);
        await tab.keyboard.press("F8"); // goes to the next error: lines that are not in sight are not in the page
        await waitFor("a mark at the line", () => tab.$eval("#editor", (place) => Boolean(place.shadowRoot.querySelector(".cm-lint-marker-error"))));
        await tab.shot(`student-${stem}-semicolon`);
        if (stem === "01-corners") {
            await write(right.replaceAll("c.width / 2 * c.right", "c.width * c.right"));
            await verdict("the whole width", /the whole width/i);
            await tab.press("#first button");
            await waitFor("the cursor in the line of the function", () => tab.$eval("#editor", (place) =>
                place.shadowRoot.querySelector(".cm-activeLine")?.textContent.includes("upper_left") && place.shadowRoot.activeElement !== null));
            assert.match(await tab.text("#first"), /the whole width/i, "the cause comes first");
            assert.deepEqual(await tab.$$eval(".results tr", (all) => all.map((each) => each.textContent)), ["expected(-1,1,4)", "yours(-2,1,4)"]);
            assert.deepEqual(await tab.$$eval(".results mark", (all) => all.map((each) => each.textContent)), ["(-2,"], "what differs is marked");
            await waitFor("the cause in the line", () => tab.$eval("#editor", (place) => /upper_left.*the whole width/i.test(
                [...place.shadowRoot.querySelectorAll(".cm-line")].map((each) => each.textContent).join("\n"))));
            assert.deepEqual(await tab.$$eval("#strip li", (all) => all.map((each) => each.dataset.state)), ["wrong", "wrong", "right", "right", "right"]);
            await waitFor("its figure", () => tab.$eval("#verdict-pictures", (place) => place.querySelector("img")?.naturalWidth > 0));
            await tab.shot(`student-${stem}-mistake`);
            assert.ok(await tab.$eval("#verdict", (each) => { each.scrollTop = 30; return each.scrollTop; }) > 0, "it is longer than its place");
            await write(right.replaceAll("(s - 0.5)", "s"));
            await verdict("s from the edge", /must start at the left edge/);
            assert.equal(await tab.$eval("#verdict", (each) => each.scrollTop), 0, "a new verdict is shown from its top");
        }
        await write(right);
        await verdict(`${stem} is right`, new RegExp(`${stem} is right`));
        assert.equal(await tab.text("#hints"), "", "hints are gone when they are done with");
        const next = stem < "08" ? readdirSync("solutions").find((name) => name.startsWith(`0${Number(stem.slice(0, 2)) + 1}-`)).slice(0, -2) : "index";
        assert.equal(await tab.$eval("#way-on a", (each) => each.getAttribute("href")), `${next}.html`, "the way to the next chapter");
        await waitFor("a mark in the list of chapters", async () => (await tab.text(`#menu li[data-stem="${stem}"]`)).includes("done"));
        if (stem < "08") {
            await waitFor("the picture", () => tab.$$eval("#verdict-pictures img", (all) => all.some((each) => each.naturalWidth > 0)));
            await tab.$eval("#verdict-pictures", (each) => each.scrollIntoView());
            // The answers of other pages are known to be right.
            assert.match(await tab.text("#verdict"), /Drawn by your own code/, stem);
            assert.doesNotMatch(await tab.text("#verdict"), FOR_A_TERMINAL);
        }
        await tab.shot(`student-${stem}-right`);
    }
    await tab.visit("index.html");
    await waitFor("progress", async () => /functions are right/.test(await tab.text("#so-far")));
    await tab.shot("student-start");
    assert.deepEqual(tab.faults, []);
    assert.deepEqual(host.sent.requests.filter((path) => /whole/.test(path)), [], "the small compiler is enough");

    // All files are there after a while; then the host may go.
    await waitFor("all files of the site", () => tab.evaluate(async () => Boolean((await navigator.serviceWorker.getRegistration())?.active)));
    await tab.visit(`${stems[0]}.html`);
    const before = host.sent.requests.length;
    await tab.visit(`${stems[0]}.html`);
    await tab.press("#judge");
    await verdict("again", / is right/);
    const asked = host.sent.requests.slice(before).filter((path) => !path.endsWith("service_worker.js"));
    assert.deepEqual(asked, [], "a later visit asks the host for nothing");
});
