// update.mjs - a site that is published again, in a real browser: a page and all that it loads are of one version, the
// new version comes when no other page is open, and a host that has two versions at once changes nothing.
//
// Usage: BROWSER=chromium|firefox node update.mjs SITE
import assert from "node:assert/strict";
import { cpSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { writeServiceWorker } from "../../../../chapters/book/site/bundle.mjs";
import { begin, waitFor } from "../site.mjs";

const [folder] = process.argv.slice(2), scratch = mkdtempSync(join(tmpdir(), "book-"));
// The pages and their scripts, without what takes long to keep.
cpSync(folder, scratch, { recursive: true, filter: (path) => !/\/(compiler|programs|chapters|figures|pictures\.pack\.gz)$/.test(path) });
const { host, openPage } = await begin(scratch);

/** Publishes a version: each page and each script says which it is. exceptFor: files that the host does not have yet. */
function publish(version, exceptFor = []) {
    for (const name of readdirSync(scratch).filter((each) => /\.(html|js)$/.test(each) && each !== "service_worker.js" && !exceptFor.includes(each))) {
        const file = join(scratch, name), text = readFileSync(file, "utf8").replace(/(<!--|\/\*) version \d+ (-->|\*\/)$/, "");
        writeFileSync(file, `${text}${name.endsWith("html") ? `<!-- version ${version} -->` : `/* version ${version} */`}`);
    }
    const now = new Map(exceptFor.map((name) => [name, readFileSync(join(scratch, name))]));
    for (const [name, bytes] of now)
        writeFileSync(join(scratch, name), `${bytes} `); // what the service worker expects
    writeServiceWorker(scratch);
    for (const [name, bytes] of now)
        writeFileSync(join(scratch, name), bytes);
}
/** The versions of a page that is open, and of what it loads now. */
const versions = async (tab) => [...new Set(await tab.evaluate(async () => {
    const said = (text) => [...text.matchAll(/(?:<!--|\/\*) version (\d+) (?:-->|\*\/)$/g)].at(-1)?.[1];
    const page = document.createTreeWalker(document, NodeFilter.SHOW_COMMENT);
    let own;
    while (page.nextNode())
        own = / version (\d+) /.exec(page.currentNode.data)?.[1] ?? own;
    const loaded = await Promise.all(["page.js", "judge_worker.js", "05-quadratic.html"].map(async (name) => said(await (await fetch(name)).text())));
    return [own, ...loaded];
}))];
const state = (tab, of) => tab.evaluate(async (of) => Boolean((await navigator.serviceWorker.getRegistration())?.[of]), of);
const reload = (tab) => tab.reload({ waitUntil: "load" }).catch(() => {}); // a page with a new version is loaded twice
// Asks for no file before the new version has taken over: a browser waits until the old service worker has nothing to do.
const isOf = (tab, version, what) => waitFor(`version ${version}: ${what}`, async () =>
    !(await state(tab, "waiting").catch(() => true)) && (await versions(tab).catch(() => [])).join() === String(version));

test("a page and all that it loads are of one version", async () => {
    publish(1);
    const tab = await openPage("index.html");
    await waitFor("the site kept", () => state(tab, "active"));
    await tab.reload({ waitUntil: "load" });
    assert.deepEqual(await versions(tab), ["1"], "the first version");

    publish(2);
    await reload(tab);
    await waitFor("the second version kept", () => state(tab, "waiting"));
    assert.deepEqual(await versions(tab), ["1"], "a page that was open has its own version to the end");
    const other = await openPage("index.html");
    await new Promise((resolve) => setTimeout(resolve, 1000)); // for a version that should not come
    assert.deepEqual(await versions(other), ["1"], "two pages have the same version");
    assert.deepEqual(await versions(tab), ["1"], "two pages have the same version");
    await other.close();
    await tab.visit("figures.html").catch(() => {}); // it is loaded twice
    await isOf(tab, 2, "a page that is opened alone");
    assert.ok(tab.url().endsWith("/figures.html"), tab.url());
    const keptFiles = await tab.evaluate(async () => {
        const cache = await caches.open((await caches.keys())[0]), paths = (await cache.keys()).map(({ url }) => url.replace(/\?.*/, ""));
        return { all: paths.length, different: new Set(paths).size };
    });
    assert.equal(keptFiles.all, keptFiles.different, "of each file one version is kept");

    // The host has the list of a third version, and not yet all its files.
    publish(3, ["page.js"]);
    const asked = host.sent.requests.length;
    await reload(tab);
    await waitFor("the host asked for the third version", () => host.sent.requests.slice(asked).some((path) => path.endsWith("/page.js")));
    await waitFor("the third version given up", async () => !(await state(tab, "installing")));
    assert.equal(await state(tab, "waiting"), false);
    await reload(tab);
    assert.deepEqual(await versions(tab), ["2"], "half a version is none");
    publish(4);
    await reload(tab);
    await waitFor("the fourth version kept", () => state(tab, "waiting"));
    host.stopSending();
    await reload(tab);
    await isOf(tab, 4, "without a network");
    // What a page was loading when it was loaded again is an error in the console, in other words in each browser.
    assert.deepEqual(tab.faults.filter((fault) => /another origin|Content.Security/i.test(fault)), []);
});
test.after(() => rmSync(scratch, { recursive: true, force: true }));
