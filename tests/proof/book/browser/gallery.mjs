// gallery.mjs - the page of pictures and figures in a real browser: each is there, in its shape and theme; nothing comes
// from elsewhere, nothing is wider than the screen, no finding of axe-core; links lead somewhere, and the keyboard reaches
// them.
//
// Usage: BROWSER=chromium|firefox node gallery.mjs SITE, after make
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import test from "node:test";
import { begin, browserName, findings } from "../site.mjs";

const { openPage } = await begin("build/solutions"), figures = readdirSync("build/solutions/figures").filter((name) => !name.startsWith("."));
const schemes = browserName === "firefox" ? ["light"] : ["light", "dark"]; // WebDriver BiDi has no dark scheme yet
test("the page of pictures", async () => {
    const tab = await openPage("gallery/index.html");
    for (const scheme of schemes) {
        if (schemes.length > 1)
            await tab.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
        for (const width of [1440, 768, 360, 320]) {
            const where = `${scheme}, ${width} pixels`;
            await tab.setViewport({ width, height: 800 });
            await tab.visit("gallery/index.html");
            await tab.evaluate(() => document.querySelectorAll("details").forEach((each) => { each.open = true; }));
            const shown = await tab.evaluate(async () => {
                const images = [...document.images];
                images.forEach((each) => { each.loading = "eager"; });
                await Promise.all(images.map((each) => each.decode()));
                return images.map(({ currentSrc, width }) => ({ path: decodeURI(new URL(currentSrc).pathname), width }));
            });
            const ending = `${width <= 600 ? "-4x3" : ""}${scheme === "dark" ? "-dark" : ""}.svg`;
            assert.deepEqual(shown.map(({ path }) => path).filter((path) => path.includes("/figures/")).sort(),
                figures.map((name) => `/course/figures/${name}/${name}${ending}`).sort(), where);
            assert.deepEqual(shown.filter((each) => each.width < 0.9 * Math.min(width, 500)), [], `${where}: small pictures`);
            assert.ok(await tab.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${where}: it is wider than the screen`);
            assert.deepEqual(await findings(tab, /./), [], where);
        }
        // Tab reaches every link in the page's order, and one sees where it is. In a video it goes from control to control.
        const count = await tab.evaluate(() => {
            globalThis.all = [...document.querySelectorAll("a[href], summary, video")].filter((each) => each.getClientRects().length);
            return globalThis.all.length;
        });
        for (let place = 0; place < count;) {
            await tab.keyboard.press("Tab");
            const reached = await tab.evaluate(() => {
                const it = document.activeElement, style = getComputedStyle(it), box = it.getBoundingClientRect();
                return { place: globalThis.all.indexOf(it), words: it.textContent.trim().slice(0, 40),
                    seen: style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2 && box.bottom > 0 && box.top < innerHeight };
            });
            if (reached.place === place - 1)
                continue;
            assert.deepEqual({ place: reached.place, seen: reached.seen }, { place, seen: true }, `${scheme}: ${reached.words}`);
            place++;
        }
    }
    for (const link of new Set(await tab.$$eval("a[href]", (all) => all.map((each) => each.href)))) {
        assert.equal((await fetch(link)).status, 200, link);
        assert.ok(await tab.evaluate((id) => id === "" || document.getElementById(id) !== null, decodeURI(new URL(link).hash.slice(1))), link);
    }
    assert.ok(await tab.$$eval("img", (all) => all.every((each) => each.alt.length >= 20 && each.getAttribute("width") && each.getAttribute("height"))),
        "every picture is described, and has a size before it is there");
    assert.deepEqual(tab.faults, []);
});
