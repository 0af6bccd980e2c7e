// figures.mjs - live figures in a real browser: each is drawn, a handle is dragged by mouse, finger and key, a number is
// typed, and what then is shown is what the same options give in the terminal.
//
// Usage: BROWSER=chromium|firefox node figures.mjs SITE [FOLDER-FOR-SCREENSHOTS]
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import test from "node:test";
import { begin, browserName, replaceText, seriousFindings, waitFor } from "../site.mjs";

const { openPage } = await begin();

const place = (name) => `.figure[data-figure="${name}"]`;
/** Waits until the figure is live. Figures above it may become taller meanwhile, so it is put into sight again. */
const isLive = (tab, name) => waitFor(`${name} live`, () => tab.$eval(place(name), (figure) => {
    if (figure.querySelector(".drawing > div")?.shadowRoot?.querySelector("svg"))
        return true;
    figure.scrollIntoView({ block: "center", behavior: "instant" });
    return false;
}));

/** What a live figure shows: its numbers, by option, and its words. */
const state = (tab, name) => tab.evaluate((at) => {
    const root = document.querySelector(at).querySelector(".drawing > div").shadowRoot;
    return { numbers: Object.fromEntries([...root.querySelectorAll("input")].map((each) => [each.name, each.value])), step: root.querySelector(".step").textContent,
        title: root.querySelector("svg title").textContent, words: root.querySelector("svg desc").textContent, wrong: root.querySelector(".wrong").textContent,
        handles: [...root.querySelectorAll(".handle:not([hidden])")].map((each) => {
            const box = each.getBoundingClientRect();
            return { label: each.getAttribute("aria-label"), x: box.x + box.width / 2, y: box.y + box.height / 2 };
        }) };
}, place(name));

async function open(page, name, size) {
    const tab = await openPage(`${page}.html`, size);
    await isLive(tab, name);
    await tab.evaluate(() => document.fonts.ready);
    return tab;
}

/** Waits until the figure shows other numbers, and nothing is being drawn. */
const changed = (tab, name, before) => waitFor(`${name} changed`, async () => {
    if (await tab.$eval(`${place(name)} .drawing`, (each) => each.getAttribute("aria-busy") !== "false"))
        return false;
    const now = await state(tab, name);
    return JSON.stringify(now.numbers) !== JSON.stringify(before.numbers) && now;
});

/** Where a handle is, when it is what the pointer would meet there: a page moves while it is laid out. */
const handleOf = (tab, name, label) => waitFor(`the handle ${label}`, async () => {
    const handle = (await state(tab, name)).handles.find((each) => each.label.startsWith(label));
    return handle && await tab.evaluate((at, { x, y }) => document.querySelector(at).querySelector(".drawing > div").shadowRoot.elementFromPoint(x, y)
        ?.classList.contains("handle"), place(name), handle) && handle;
});

async function drag(tab, { x, y }, dx, dy) {
    await tab.mouse.move(x, y);
    await tab.mouse.down();
    for (let i = 1; i <= 8; i++)
        await tab.mouse.move(x + (dx * i) / 8, y + (dy * i) / 8);
    await tab.mouse.up();
}

async function touch(tab, { x, y }, dx, dy) {
    const finger = await tab.touchscreen.touchStart(x, y);
    for (let i = 1; i <= 4; i++)
        await finger.move(x + (dx * i) / 4, y + (dy * i) / 4);
    await finger.end();
}

const numbers = (text) => text.split(",").map(Number);

test("live figures, by mouse, finger, key and number", async () => {
    // All figures of the course become live, without a fault.
    const stems = readdirSync("chapters").filter((each) => /^0[1-7]-/.test(each)), all = await openPage("index.html");
    for (const stem of stems) {
        await all.visit(`${stem}.html`);
        await all.evaluate(() => document.querySelectorAll(".lesson details").forEach((each) => { each.open = true; }));
        for (const name of new Set(await all.$$eval(".figure", (figures) => figures.map((each) => each.dataset.figure)))) {
            await isLive(all, name);
            const now = await state(all, name);
            assert.ok(now.title.length > 5 && now.words.length > 20, `${name} has words`);
            assert.deepEqual(await all.$eval(`${place(name)} .drawing > div`, ({ shadowRoot }) =>
                [...shadowRoot.querySelectorAll(".bar-fields, input")].filter((each) => each.scrollWidth > each.clientWidth).map((each) => each.name || "fields")), [], `${name}: numbers that are cut`);
            await all.shot(`live-${name}`, await all.$(place(name)));
        }
        assert.deepEqual(await seriousFindings(all), [], `${stem} with live figures`);
    }
    assert.deepEqual(all.faults, []);
    await all.close();

    // By mouse: the center of the sphere follows the pointer, to the right and up; then it is put back.
    const tab = await open("05-quadratic", "ray-sphere"), first = await state(tab, "ray-sphere");
    assert.deepEqual(first.numbers, { origin: "-4,-1,0", direction: "0.89,0.45,0", center: "0,0,0", radius: "1" });
    // The numbers of the example in the text of the lesson.
    const inText = () => tab.evaluate(() => Object.fromEntries([...document.querySelectorAll(".lesson [data-number]")].map((each) => [each.dataset.number, each.textContent])));
    const inLecture = await inText();
    await drag(tab, await handleOf(tab, "ray-sphere", "C,"), 30, -20);
    const moved = await changed(tab, "ray-sphere", first), [x, y, z] = numbers(moved.numbers.center);
    assert.ok(x > 0 && y > 0 && z === 0 && Math.abs(x / y - 1.5) < 0.1, `the center is at ${moved.numbers.center}`);
    assert.notEqual(moved.words, first.words);

    // By key: the radius grows and shrinks. By number: a wrong one is explained, a right one drawn.
    const focus = (name, number) => tab.evaluate((at, i) => document.querySelector(at).querySelector(".drawing > div").shadowRoot.querySelectorAll(".handle")[i].focus(),
        place(name), number);
    await focus("ray-sphere", 3);
    await tab.keyboard.press("ArrowRight");
    const grown = await changed(tab, "ray-sphere", moved);
    assert.ok(Number(grown.numbers.radius) > 1, `the radius is ${grown.numbers.radius}`);
    const type = async (name, option, value) => {
        await tab.evaluate((at, which) => {
            const input = document.querySelector(at).querySelector(".drawing > div").shadowRoot.querySelector(`input[name=${which}]`);
            input.focus();
            input.select();
        }, place(name), option);
        await tab.keyboard.type(value);
        await tab.keyboard.press("Enter");
    };
    await type("ray-sphere", "radius", "-1");
    const wrong = await waitFor("a message", async () => (await state(tab, "ray-sphere")).wrong);
    assert.match(wrong, /--radius: expected a number greater than 0/);
    await type("ray-sphere", "radius", "0.25");
    await waitFor("the typed radius", async () => { const now = await state(tab, "ray-sphere"); return now.numbers.radius === "0.25" && now.wrong === ""; });

    // The numbers in the lesson are those of the figure: c is p.p - r^2. The small sphere is missed.
    const follow = (what, wanted) => waitFor(`the numbers in the lesson ${what}`, async () => wanted(await inText()));
    await type("ray-sphere", "center", "0,0,0");
    await follow("follow", (its) => its.radius === "0.25" && its.center === "(0, 0, 0)" && its.c === "16.9375" && its.t0 === "none");
    await type("ray-sphere", "origin", "-4,-2,0");
    await type("ray-sphere", "radius", "1");
    await follow("follow a typed origin", (its) => its.ray_origin === "(−4, −2, 0)" && its.c === "19" && its.b === "−8.92" && Number(its.t0) > 3 && Number(its.t1) > Number(its.t0));
    assert.deepEqual(await seriousFindings(tab), [], "numbers that follow");

    // Steps, and back to the lecture's numbers.
    const press = (name, what) =>
        tab.evaluate((at, which) => document.querySelector(at).querySelector(".drawing > div").shadowRoot.querySelector(which).click(), place(name), what);
    const step = (await state(tab, "ray-sphere")).step;
    await press("ray-sphere", ".back");
    await waitFor("a step back", async () => (await state(tab, "ray-sphere")).step !== step);
    await press("ray-sphere", ".reset");
    await waitFor("the first numbers", async () => JSON.stringify((await state(tab, "ray-sphere")).numbers) === JSON.stringify(first.numbers));
    await follow("are the lecture's again", (its) => JSON.stringify(its) === JSON.stringify(inLecture));
    assert.deepEqual(tab.faults, []);
    await tab.close();

    // By finger, on a telephone: a pixel. (WebDriver BiDi has no touch yet in this Firefox.)
    if (browserName === "chromium") {
        const phone = await open("06-ray-casting", "ray-casting", { width: 390, height: 844 }), before = await state(phone, "ray-casting");
        await touch(phone, await handleOf(phone, "ray-casting", before.handles[0].label), 0, 12);
        const after = await changed(phone, "ray-casting", before);
        assert.ok(numbers(after.numbers.pixel)[1] > numbers(before.numbers.pixel)[1], `the pixel is ${after.numbers.pixel}`);
        assert.deepEqual(phone.faults, []);
        await phone.close();
    }
});

test("a letter of a formula lights up in formulas, figure and code", async () => {
    const tab = await open("05-quadratic", "ray-sphere", { width: 1440, height: 900 });
    await replaceText(tab, "// the ray's origin\nvec3 f(Ray ray, Ray moved_ray, double radius)\n{\n    return ray.origin + moved_ray.origin * radius * r;\n}\n");
    const lit = () => tab.evaluate((at) => ({ formulas: [...document.querySelectorAll(".lesson .lit")].map((each) => each.textContent),
        figure: [...document.querySelector(at).querySelector(".drawing > div").shadowRoot.querySelectorAll(".lit")].map((each) => each.textContent).join(),
        code: [...CSS.highlights.get("lit") ?? []].filter((range) => range.startContainer.getRootNode() !== document).map(String).join() }), place("ray-sphere"));
    // Until the page is laid out, what is under the pointer may move away.
    const point = (letter, inFigure) => waitFor(`${letter} lit`, async () => {
        for (const each of await tab.$$(".lesson p .katex-html .mathnormal"))
            if (await each.evaluate((it, wanted) => it.textContent === wanted && it.nextSibling === null, letter)) {
                await tab.mouse.move(1, 1);
                await each.evaluate((it) => it.scrollIntoView({ block: "center", behavior: "instant" }));
                await each.hover();
                const now = await lit();
                return now.figure === inFigure && now;
            }
    });
    const p = await point("p", "p,p");
    assert.ok(p.formulas.length > 10 && p.formulas.every((each) => each === "p"), `formulas: ${p.formulas}`);
    assert.equal(p.code, "ray.origin,moved_ray.origin"); // the comment is words
    assert.equal((await point("r", "r")).code, "radius,radius,r");
    await tab.shot("letter", tab);
    await tab.mouse.move(1, 1);
    await waitFor("no light", async () => JSON.stringify(await lit()) === '{"formulas":[],"figure":"","code":""}');
    await tab.$$eval(".lesson details", (all) => all.forEach((each) => { each.open = true; }));
    await tab.focus(".mathematics");
    await waitFor("v lit by a key", async () => { await tab.keyboard.press("v"); return (await lit()).figure === "v,v"; });
    await waitFor("a verdict", () => tab.$eval("#verdict", (each) => !each.classList.contains("old"))); // it is pale until then
    assert.deepEqual(await seriousFindings(tab), []);
    assert.deepEqual(tab.faults, []);
});
