// write_service_worker.mjs - writes the service worker of a site: page/service_worker.js, and the list of all files that
// a page may load.
import { createHash } from "node:crypto";
import { readFileSync, readdirSync, statSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";

export function writeServiceWorker(site) {
    const files = readdirSync(site, { recursive: true, withFileTypes: true }).filter((each) => each.isFile()).map((each) => relative(site, join(each.parentPath ?? each.path, each.name)))
        .filter((name) => name !== "service_worker.js" && name !== "tree/plan").sort(); // the plan is in one with other texts
    const sizes = Object.fromEntries(files.map((name) => [name, statSync(join(site, name)).size]));
    const names = Object.fromEntries(files.map((name) => [name, createHash("sha256").update(readFileSync(join(site, name))).digest("hex")]));
    // The small ones first. The whole compiler is kept when it is first needed, which is seldom.
    const order = files.filter((name) => !name.includes("whole.wasm")).sort((a, b) => sizes[a] - sizes[b] || (a < b ? -1 : 1));
    const worker = readFileSync(new URL("../page/service_worker.js", import.meta.url), "utf8");
    writeFileSync(join(site, "service_worker.js"), `const FILES = ${JSON.stringify(names)}, ORDER = ${JSON.stringify(order)};\n${worker}`);
}
