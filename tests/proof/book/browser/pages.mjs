// pages.mjs - every page in a real browser: no error, nothing from another origin, nothing that its policy forbids, no
// link that leads nowhere, nothing wider than the screen, no serious finding of axe-core; light and dark, wide and narrow.
//
// Usage: BROWSER=chromium|firefox node pages.mjs SITE [FOLDER-FOR-SCREENSHOTS]
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { browserName, launch, openTab, seriousFindings, serve, waitFor } from "../site.mjs";

const [folder, shots] = process.argv.slice(2);
const host = await serve(folder), browser = await launch();
const pages = readdirSync(folder).filter((name) => name.endsWith(".html")).concat("listings/exercises/05-quadratic.h.html");
let links = new Set();
try {
    for (const name of pages) {
        for (const [width, theme] of [[1280, "light"], [390, "dark"]]) {
            const tab = await openTab(browser, host.address, { width, height: 844 });
            // Firefox's driver cannot say what the system's theme is; the page's own choice is the same style.
            await tab.evaluateOnNewDocument((chosen) => localStorage.setItem("ray-casting theme", chosen), theme);
            await tab.goto(host.address + name, { waitUntil: "load" });
            if (await tab.$("#editor"))
                await waitFor("an editor", 20, () => tab.$eval("#editor", (place) => place.shadowRoot?.querySelector(".cm-content") !== null));
            const tooWide = () => tab.evaluate(() => document.documentElement.scrollWidth - innerWidth);
            assert.ok(await tooWide() <= 0, `${name} is ${await tooWide()} pixels wider than ${width}`);
            await tab.evaluate(() => document.querySelectorAll(".lesson details").forEach((each) => { each.open = true; }));
            assert.deepEqual(await seriousFindings(tab), [], `${name}, ${theme}, ${width} pixels`);
            if (width === 390) {
                await tab.setViewport({ width: 360, height: 640 });
                assert.ok(await tooWide() <= 0, `${name} is ${await tooWide()} pixels wider than 360`);
                await tab.setViewport({ width, height: 844 });
            }
            if (shots)
                await tab.screenshot({ path: join(shots, `${name.replace(/\W/g, "-")}-${width}-${theme}.png`) });
            (await tab.$$eval("a[href]", (all) => all.map((each) => each.href))).forEach((link) => links.add(link));
            assert.deepEqual(tab.faults, [], `${name}, ${theme}, ${width} pixels`);
            await tab.close();
        }
    }
    links = [...links].filter((link) => link.startsWith(host.address));
    for (const link of new Set(links.map((each) => each.split("#")[0])))
        assert.equal((await fetch(link)).status, 200, link);
    console.log(`pages (${browserName}): ${pages.length} pages in 3 widths, ${links.length} links: nothing to complain about`);
} finally {
    await browser.close();
    await host.stop();
}
