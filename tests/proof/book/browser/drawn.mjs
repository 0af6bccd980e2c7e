// drawn.mjs - a right answer in a real browser gets its verdict and the picture that it draws. The site of a handout has no
// reference to draw the rest by, so there it is the first chapter's.
//
// Usage: BROWSER=chromium|firefox node drawn.mjs SITE
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { browserName, launch, openTab, replaceText, serve, waitFor, waitForEditor } from "../site.mjs";

const [folder] = process.argv.slice(2), isHandout = existsSync(join(folder, "tables")), stem = isHandout ? "01-corners" : "05-quadratic";
const host = await serve(folder), browser = await launch();
try {
    const tab = await openTab(browser, host.address);
    const source = readFileSync(`solutions/${stem}.c`, "utf8");
    await tab.goto(`${host.address}${stem}.html`, { waitUntil: "load" });
    await waitForEditor(tab);
    await replaceText(tab, source, { judge: true });
    const text = () => tab.$eval("#verdict", (place) => place.textContent);
    await waitFor("a verdict", async () => (await text()).includes(`${stem} is right.`));
    await waitFor("a picture", async () => (await text()).includes(`gallery/${stem}.png`));
    assert.match(await text(), isHandout ? /drawn by your own code/ : /Yours: hit_sphere\.\s+By\s+the\s+reference:\s+pixel_ray\./);
    const size = () => tab.$eval("#verdict-pictures img", (img) => [img.naturalWidth, img.naturalHeight]);
    await waitFor("its pixels", async () => (await size())[0] > 100);
    if (process.env.SCREENSHOT)
        await tab.screenshot({ path: process.env.SCREENSHOT, fullPage: false });
    assert.deepEqual(host.sent.requests.filter((path) => /whole/.test(path)), [], "the small compiler is enough");
    assert.deepEqual(tab.faults, []);
    console.log(`drawn (${browserName}): passed`);
} finally {
    await browser.close();
    await host.stop();
}
