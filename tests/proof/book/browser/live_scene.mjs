// live_scene.mjs - the scene beside an exercise: cast by the student's functions, right or wrong; its things are dragged, its
// text is written, a link holds it, and a pixel tells its story.
//
// Usage: BROWSER=chromium|firefox node live_scene.mjs SITE [FOLDER-FOR-SCREENSHOTS]
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { begin, openTab, replaceInEditor, replaceText, seriousFindings, waitFor } from "../site.mjs";

const { host, browser, openPage } = await begin();
const stem = "07-shading", right = readFileSync(`solutions/${stem}.c`, "utf8");
const tab = await openPage(`${stem}.html`, { width: 1440, height: 900 });

/** The panel, as soon as its picture is fine. */
const state = () => tab.$eval(".live-scene", (each) => {
    const canvas = each.querySelector("canvas"), small = Object.assign(document.createElement("canvas"), { width: 32, height: 24 }).getContext("2d");
    small.drawImage(canvas, 0, 0, 32, 24);
    return { isFine: canvas.hasAttribute("data-fine"), colors: [...small.getImageData(0, 0, 32, 24).data], credit: each.querySelector(".credit").textContent,
        trouble: each.querySelector(".note").textContent, things: [...each.querySelectorAll(".handles button")].map((handle) => handle.getAttribute("aria-label")),
        story: each.querySelector(".story").textContent };
}).catch(() => ({}));
const fine = (what, isWanted) => waitFor(what, async () => { const now = await state(); return now.isFine && isWanted(now) && now; });
const apart = (a, b) => Math.max(...a.colors.map((each, at) => Math.abs(each - b.colors[at])));
const sphereA = (now) => /^sphere A at (.*)\. Drag/.exec(now.things.find((each) => each.startsWith("sphere A")))[1].split(",").map(Number);

test("a scene beside the exercise", async (t) => {
    let reference;
    await t.test("the reference casts it, while nothing is answered", async () => {
        const panel = () => tab.$eval(".live-scene", (each) => `${each.open} ${getComputedStyle(each).position}`), press = () => tab.press("#reset + button");
        await waitFor("a panel", () => tab.$(".live-scene"));
        assert.equal(await panel(), "false static", "closed, it covers nothing");
        await press();
        assert.equal(await panel(), "true sticky");
        await press();
        assert.equal(await panel(), "false static");
        await tab.$eval("#editor", (place) => place.shadowRoot.querySelector(".cm-content").focus()); // that opens it
        reference = await fine("a picture", ({ credit }) => /the reference/.test(credit));
        assert.equal(reference.things.length, 4, "three spheres and a light");
    });
    await t.test("right answers give the same picture; a wrong one is seen at once, and the others stay", async () => {
        await replaceText(tab, right, { judge: true });
        const mine = await fine("a picture by the answers", ({ credit }) => /^Yours: .*trace_ray/.test(credit));
        assert.ok(apart(reference, mine) <= 1, `the pictures differ by ${apart(reference, mine)}`);
        // Only the normal is answered, the same everywhere: the reference's light calls it.
        const blank = right.replace(/\/\/ BEGIN SOLUTION\n( *\/\/~ .*\n)?[^]*?\/\/ END SOLUTION/g, (all) => /~ return/.test(all) ? all.match(/\/\/~ (.*)/)[1] : "");
        const wrong = blank.replace("return NOT_ANSWERED(vec3);", "return vec3_of(0, 0, 1);");
        await replaceText(tab, wrong, { judge: true });
        const seen = await fine("a wrong picture", ({ credit }) => /surface_normal \(not right yet\)/.test(credit));
        assert.ok(apart(reference, seen) > 50, "a wrong normal is seen");
        await tab.shot("live-scene-wrong");
        await replaceText(tab, right, { judge: true });
        await fine("the right picture", (now) => /trace_ray/.test(now.credit) && apart(reference, now) <= 1);
    });
    await t.test("a sphere is moved by mouse and by key; the camera by key", async () => {
        const at = await tab.$eval('.handles button[data-kind="s"]', (each) => { const box = each.getBoundingClientRect(); return { x: box.x + box.width / 2, y: box.y + box.height / 2 }; });
        const before = sphereA(await state());
        await tab.mouse.move(at.x, at.y);
        await tab.mouse.down();
        await tab.mouse.move(at.x + 40, at.y - 20, { steps: 5 });
        await tab.mouse.up();
        const moved = await fine("a moved sphere", (now) => sphereA(now)[0] > before[0] && apart(reference, now) > 50), [x, y, z] = sphereA(moved);
        // 320 pixels are 2 (20 - 1) tan(42/2) at the distance of its center.
        const unit = 2 * 19 * Math.tan(21 * Math.PI / 180) / 320;
        assert.ok(Math.abs(x - before[0] - 40 * unit) < 0.01 && Math.abs(y - before[1] - 20 * unit) < 0.01 && Math.abs(z - before[2]) < 0.01, `it is at ${[x, y, z]}`);
        await tab.$eval('.handles button[data-kind="s"]', (each) => each.focus());
        await tab.keyboard.press("ArrowLeft");
        await fine("a sphere to the left", (now) => sphereA(now)[0] < x);
        const still = await state();
        await tab.focus(".stage canvas");
        await tab.keyboard.press("ArrowRight");
        await fine("a turned picture", (now) => apart(still, now) > 20);
    });
    await t.test("a pixel tells its story, by the functions of the chapters", async () => {
        await tab.$eval(".live-scene input", (each) => { each.value = "160,120"; each.dispatchEvent(new Event("change")); });
        const { story } = await fine("a story", (now) => /normal/.test(now.story));
        for (const words of ["(160.5, 120.5)03 pixel_center", "05 sphere_roots", "07 surface_normal", "07 trace_ray"])
            assert.ok(story.includes(words), words);
        await tab.shot("live-scene-story");
        assert.deepEqual(await seriousFindings(tab), []);
    });
    await t.test("its rays are drawn in the scene, with the numbers of the story, and seen from beside", async () => {
        await tab.$$eval(".live-scene select", ([scenes]) => { scenes.value = "three-spheres"; scenes.dispatchEvent(new Event("change")); });
        const put = (pixel) => tab.$eval(".live-scene input", (each, words) => { each.value = words; each.dispatchEvent(new Event("change")); }, pixel);
        const drawn = () => tab.$eval(".stage svg", (svg) => ({ names: [...svg.querySelectorAll("line")].map((each) => each.getAttribute("class")).join(" "),
            words: svg.textContent, ...Object.fromEntries([...svg.querySelectorAll("line")].map((each) => [each.getAttribute("class"), ["x1", "y1", "x2", "y2"].map((of) => Number(each.getAttribute(of)))])) }));
        await fine("the three spheres", (now) => apart(reference, now) <= 1);
        await put("185,55");
        const { story } = await fine("its story", (now) => /\(185\.5, 55\.5\)/.test(now.story)), told = (label) => new RegExp(`${label}\\((.*?)\\)`).exec(story)[1].split(", ").map(Number);
        // The eye is at (0, 0, 20) and looks along -z; 42 degrees are a picture's width.
        const place = ([x, y, z]) => [x, -y].map((of) => of / (2 * (20 - z) * Math.tan(21 * Math.PI / 180)));
        const point = told("point"), normal = told("normal"), light = told("from the point to it");
        const { names, ray, normal: n, light: l } = await drawn(), isNear = (a, b) => a.every((each, i) => Math.abs(each - b[i]) < 1e-4);
        assert.equal(names, "ray normal light mirror");
        assert.ok(isNear(ray.slice(2), [(185.5 - 160) / 320, (55.5 - 120) / 320]), `from the eye, the ray ends in its pixel: ${ray}`);
        assert.ok(isNear(n, [...place(point), ...place(point.map((x, i) => x + 0.12 * 2 * (20 - point[2]) * Math.tan(21 * Math.PI / 180) * normal[i]))]), `the normal is ${n}`);
        assert.ok(isNear(l, [...place(point), ...place(point.map((x, i) => x + light[i]))]), `the light is ${l}`);
        await tab.shot("live-scene-ray-from-eye", await tab.$(".live-scene"));
        const before = await state(), turn = () => tab.press(".live-side > button");
        await turn();
        await fine("another viewpoint", (now) => apart(before, now) > 50);
        const aside = await drawn();
        assert.match(aside.words, /p, the eye.*screen.*p \+ t v/);
        assert.ok(Math.hypot(aside.ray[2] - aside.ray[0], aside.ray[3] - aside.ray[1]) > 0.4, "the ray is seen");
        assert.equal((await state()).story, before.story);
        await tab.shot("live-scene-ray-from-beside", await tab.$(".live-scene"));
        await put("160,120"); // in the shadow, and four mirrors
        await waitFor("another ray", async () => /shadow mirror mirror mirror|light mirror mirror mirror/.test((await drawn()).names));
        await turn();
        await fine("the viewpoint before", (now) => apart(before, now) <= 1);
    });
    let link;
    await t.test("a written scene has its errors at the line, and a link holds it", async () => {
        await tab.$$eval(".live-scene .actions button", (all) => all.find((each) => each.textContent === "Write").click());
        await waitFor("an editor of the scene", () => tab.$eval(".scene-text", (place) => Boolean(place.shadowRoot?.querySelector(".cm-content"))));
        const write = (text) => tab.$eval(".scene-text", replaceInEditor, text, false);
        const view = "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nresolution 4 3\nl 0 9 9\n";
        await write(`${view}s 0 0 0 -1\n`);
        await waitFor("a message", async () => /line 8: a radius of -1, expected more than 0/.test((await state()).trouble));
        await waitFor("a mark at the line", () => tab.$eval(".scene-text", (place) => Boolean(place.shadowRoot.querySelector(".cm-lintRange-error"))));
        await tab.shot("live-scene-written");
        await write(`${view}f 1 0 0 1 0 0 0 1\ns 0 0 0 2\n`);
        const own = await fine("the written scene", ({ trouble, things }) => trouble === "" && things.length === 2);
        await tab.$$eval(".live-scene .actions button", (all) => all.find((each) => each.textContent === "Link").click());
        link = await waitFor("a link", () => tab.evaluate(() => location.hash.startsWith("#scene=") && location.href));
        const other = await openTab(browser, host.address);
        await other.goto(link, { waitUntil: "load" });
        await waitFor("the scene of the link", () => other.$eval(".live-scene", (each) =>
            each.querySelector("canvas[data-fine]") && each.querySelectorAll(".handles button").length === 2 && each.querySelector("select").value === "your own").catch(() => false));
        assert.deepEqual(sphereA(own), [0, 0, 0]);
        assert.deepEqual(other.faults, []);
        await other.close();
    });
    await t.test("an endless loop is stopped by the next change", async () => {
        await replaceText(tab, right.replace("Hit hit = nearest_hit(ray, scene);", "Hit hit = nearest_hit(ray, scene); for (volatile int i = 0; i < 1; i *= 2) {}"), { judge: true });
        await waitFor("a picture that is not drawn", async () => /trace_ray \(not right yet\)/.test((await state()).credit));
        await replaceText(tab, right, { judge: true });
        await fine("a picture again", ({ credit }) => /trace_ray/.test(credit) && !/not right/.test(credit));
    });
    await t.test("while the compiler is fetched, no picture is missing", async () => {
        await tab.evaluate(async () => (await navigator.serviceWorker.getRegistration())?.unregister());
        const go = host.hold(/compiler/), before = host.sent.requests.length, page = await openPage("04-pixel-ray.html", { width: 1440, height: 900 });
        await waitFor("a panel", () => page.$(".live-scene"));
        await page.press("#reset + button");
        await waitFor("its scene", () => host.sent.requests.slice(before).some((path) => /three-spheres/.test(path)));
        await new Promise((resolve) => setTimeout(resolve, 1000));
        assert.deepEqual(await page.$eval(".live-scene", (each) => [each.querySelector(".note").textContent, each.querySelector("canvas").hasAttribute("data-fine")]), ["", false]);
        go();
        await waitFor("a picture by the answers", () => page.$eval(".live-scene", (each) => /^Yours: .*trace_ray/.test(each.querySelector(".credit").textContent) && each.querySelector("canvas[data-fine]")));
        await page.close();
    });
    await t.test("nothing went wrong in the page", () => assert.deepEqual(tab.faults, []));
});

test("a race of both orders and the engines", async () => {
    const page = await openPage("06-ray-casting.html", { width: 1440, height: 900 });
    await waitFor("a panel", () => page.$(".live-scene"));
    await page.press("#reset + button");
    const isFine = () => page.$eval(".stage canvas", (each) => each.hasAttribute("data-fine")), begin = () => page.$$eval(".live-scene .actions button", (all) => all.find((each) => each.textContent === "Race").click());
    const race = () => page.$eval(".race", (section) => ({ said: section.querySelector("p").textContent, racers: Object.fromEntries([...section.querySelectorAll("li")].map((each) =>
        [each.querySelector("b").textContent, { words: each.querySelector("span").textContent, picture: each.querySelector("canvas").toDataURL() }])) }));
    await waitFor("a picture", isFine);
    assert.deepEqual(await page.$$eval(".live-scene select", (all) => all.map((each) => each.value)), ["three-spheres", "image order"], "what calls the exercise casts first");
    await begin();
    const { racers } = await waitFor("the end of a race", async () => { const now = await race(); return Object.values(now.racers).filter(({ words }) => /a pixel/.test(words)).length === 7 && now; });
    const asked = (name) => Number(/([\d.]+) a pixel/.exec(racers[name].words)[1]);
    assert.equal(new Set(Object.values(racers).map(({ picture }) => picture)).size, 1, "all have the same picture");
    assert.deepEqual([asked("image order"), asked("object order")], [3, 3], "every pixel, by every sphere");
    // The lesson of chapter 08: 21.1 % of these questions; and a pixel more at each side, of 160 x 120.
    assert.ok(asked("object") >= 0.6 && asked("object") <= 0.75 && asked("bins") <= asked("object"), JSON.stringify(Object.entries(racers).map(([name, { words }]) => [name, words])));
    await page.shot("race", await page.$(".live-scene"));
    assert.deepEqual(await seriousFindings(page), []);
    // The next edit ends one.
    await page.$eval(".live-scene select", (each) => { each.value = "sphereflake-820"; each.dispatchEvent(new Event("change")); });
    await waitFor("many spheres", () => page.$eval(".live-scene", (each) => !each.querySelector('.handles [data-kind="s"]') && each.querySelector(".stage canvas").hasAttribute("data-fine")));
    await begin();
    await waitFor("a race", async () => /^Casting/.test((await race()).said));
    await page.$eval("#editor", (place) => place.shadowRoot.querySelector(".cm-content").focus());
    await page.keyboard.type(" ");
    assert.equal((await race()).said, "The race was stopped.");
    const left = Object.keys((await race()).racers).length;
    await new Promise((resolve) => setTimeout(resolve, 1500));
    assert.equal(Object.keys((await race()).racers).length, left);
    assert.deepEqual(page.faults, []);
});
