// bundle.mjs - bundles the page's modules, and writes the service worker. Runs when the site is built, last.
//
// Usage: node bundle.mjs SITE
import { createHash } from "node:crypto";
import { readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

/** Writes the service worker of a site: page/service_worker.js, and the list of all files that a page may load. */
export function writeServiceWorker(site) {
    const files = readdirSync(site, { recursive: true, withFileTypes: true }).filter((each) => each.isFile())
        .map((each) => relative(site, join(each.parentPath ?? each.path, each.name)))
        .filter((name) => !["service_worker.js", "tree/plan", "share.png"].includes(name)).sort(); // the plan is in one with other texts; no page has share.png in it
    const sizes = Object.fromEntries(files.map((name) => [name, statSync(join(site, name)).size]));
    const names = Object.fromEntries(files.map((name) => [name, createHash("sha256").update(readFileSync(join(site, name))).digest("hex")]));
    // The small ones first. The whole compiler is kept when it is first needed, which is seldom.
    const order = files.filter((name) => !name.includes("whole.wasm")).sort((a, b) => sizes[a] - sizes[b] || (a < b ? -1 : 1));
    const worker = readFileSync(new URL("../page/service_worker.js", import.meta.url), "utf8");
    writeFileSync(join(site, "service_worker.js"), `const FILES = ${JSON.stringify(names)}, ORDER = ${JSON.stringify(order)};\n${worker}`);
}

async function bundleAll(site) {
    const here = fileURLToPath(new URL(".", import.meta.url)); // node 18 has no import.meta.dirname
    for (const name of readdirSync(site).filter((each) => /^part-.*\.js$/.test(each)))
        rmSync(join(site, name));
    const bundle = (names, more = {}) => build({
        entryPoints: Object.fromEntries(names.map((name) => [name.split("/").pop().replace(".js", ""), join(here, "..", name)])),
        outdir: site, bundle: true, minify: true, format: "esm", target: "es2022", legalComments: "none", logLevel: "warning", ...more,
    });
    await bundle(["page/page.js"], { splitting: true, chunkNames: "part-[hash]", define: { COURSE: readFileSync(`${site}-course.json`, "utf8") } });
    // The lecture is a classic script, which a browser also runs from a file.
    await bundle(["page/lecture.js"], { format: "iife" });
    // A Worker is one file, because it starts after that: a part would be fetched after it.
    await bundle(["figure_worker.js", "judge_worker.js", "cast/cast_worker.js"], {
        external: ["module", "fs", "path", "url"], // gnuplot's module asks for them in node, not in a page
    });
    writeServiceWorker(site);
}

if (process.argv[1] === fileURLToPath(import.meta.url))
    await bundleAll(process.argv[2]);
