// pages.mjs - every page in a real browser: no error, nothing from another origin, nothing that its policy forbids, no
// link that leads nowhere, nothing wider than the screen, nothing on paper that is to be clicked, no serious finding of axe-core; light and dark, wide and narrow.
//
// Usage: BROWSER=chromium|firefox node pages.mjs SITE [FOLDER-FOR-SCREENSHOTS]
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import test from "node:test";
import { begin, browserName, FOR_A_TERMINAL, seriousFindings, waitFor } from "../site.mjs";

const { folder, host, openPage } = await begin();
const pages = readdirSync(folder).filter((name) => name.endsWith(".html")).concat("listings/exercises/05-quadratic.h.html");
const links = new Set();
test("every page, light and dark, wide and narrow", async () => {
    for (const name of pages) {
        const tab = await openPage(name);
        await waitFor("the page's script", () => tab.$eval("#theme", (each) => each.title !== "" || document.documentElement.dataset.kind === "lecture"));
        if (/^\d/.test(name))
            assert.deepEqual((await tab.$eval("main", (each) => each.textContent)).split("\n").filter((line) => FOR_A_TERMINAL.test(line)), [], name);
        (await tab.$$eval("a[href]", (all) => all.map((each) => each.href))).forEach((link) => links.add(link));
        for (const [width, theme] of [[1280, "light"], [1024, "light"], [390, "dark"], [360, "dark"]]) {
            await tab.setViewport({ width, height: 844 });
            if (await tab.evaluate(() => getComputedStyle(document.body).backgroundColor === "rgb(255, 255, 255)") !== (theme === "light"))
                await tab.$eval("#theme", (each) => each.click());
            const wide = await tab.evaluate(() => document.documentElement.scrollWidth - innerWidth);
            assert.ok(wide <= 0, `${name} is ${wide} pixels wider than ${width}`);
            if (width === 1024)
                assert.ok(await tab.$$eval(".top", (all) => all.every((each) => each.offsetHeight < 60)), `${name}: the head of the page has one row`);
            if (width === 360)
                assert.ok(await tab.$$eval("#menu", (all) => all.every((each) => { each.showPopover(); return each.getBoundingClientRect().right <= innerWidth; })), `${name}: the titles fit`);
            if (width === 360 || width === 1024)
                continue;
            await tab.evaluate(() => document.querySelectorAll(".lesson details").forEach((each) => { each.open = true; }));
            await tab.shot(`${name.replace(/\W/g, "-")}-${width}-${theme}`);
            assert.deepEqual(await seriousFindings(tab), [], `${name}, ${theme}, ${width} pixels`);
        }
        if (/^\d/.test(name) && browserName === "chromium") { // puppeteer cannot do it in Firefox
            await tab.emulateMediaType("print");
            assert.deepEqual(await tab.evaluate(() => [document, ...[...document.querySelectorAll(".live .drawing > div")].map((each) => each.shadowRoot)]
                .flatMap((root) => [...root.querySelectorAll("header.top, .exercise, .views, .live-scene, button, input")]).filter((each) => each.checkVisibility()).map((each) => each.className)), [], `${name} on paper`);
            await tab.emulateMediaType("screen");
        }
        assert.match(await tab.$eval("meta[name=description]", (each) => each.content), /^(You w|W)rite .{20}/, `${name}: what a shared link shows`);
        const picture = new URL(await tab.$eval("meta[property='og:image']", (each) => each.content), tab.url()).pathname.split("/").pop();
        assert.deepEqual(readFileSync(`${folder}/${picture}`).readUInt32BE(16), 1200, `${name}: the width of its picture`);
        assert.deepEqual(tab.faults, [], name);
        await tab.close();
    }
    const own = [...links].filter((link) => link.startsWith(host.address));
    for (const link of new Set(own.map((each) => each.split("#")[0])))
        assert.equal((await fetch(link)).status, 200, link);
});
