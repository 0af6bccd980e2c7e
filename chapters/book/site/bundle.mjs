// bundle.mjs - bundles the page's modules, and writes the service worker with the list of all files of the site. Runs
// when the site is built, last.
//
// Usage: node bundle.mjs SITE
import { createHash } from "node:crypto";
import { readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const [site] = process.argv.slice(2);
const here = fileURLToPath(new URL(".", import.meta.url)); // node 18 has no import.meta.dirname
for (const name of readdirSync(site).filter((each) => /^part-.*\.js$/.test(each)))
    rmSync(join(site, name));
await build({
    entryPoints: { page: join(here, "../page/page.js"), worker: join(here, "../worker.js") },
    outdir: site, bundle: true, minify: true, splitting: true, format: "esm", target: "es2022", chunkNames: "part-[hash]", legalComments: "none", logLevel: "warning",
    external: ["module", "fs", "path", "url"], // gnuplot's module asks for them in node, not in a page
});

/** Files that a page may load. The plan is in one with other texts. */
const files = readdirSync(site, { recursive: true, withFileTypes: true }).filter((each) => each.isFile()).map((each) => relative(site, join(each.parentPath, each.name)))
    .filter((name) => name !== "service_worker.js" && name !== "tree/plan").sort();
const sizes = Object.fromEntries(files.map((name) => [name, statSync(join(site, name)).size]));
const names = Object.fromEntries(files.map((name) => [name, createHash("sha256").update(readFileSync(join(site, name))).digest("hex").slice(0, 16)]));
// The small ones first. The whole compiler is kept when it is first needed, which is seldom.
const order = files.filter((name) => !name.includes("whole.wasm")).sort((a, b) => sizes[a] - sizes[b] || (a < b ? -1 : 1));
const worker = readFileSync(join(here, "../page/service_worker.js"), "utf8");
writeFileSync(join(site, "service_worker.js"), `const FILES = ${JSON.stringify(names)}, ORDER = ${JSON.stringify(order)};\n${worker}`);
