// bundle.mjs - bundles the page's modules, and writes the service worker. Runs when the site is built, last.
//
// Usage: node bundle.mjs SITE
import { readFileSync, readdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { writeServiceWorker } from "./write_service_worker.mjs";

const [site] = process.argv.slice(2);
const here = fileURLToPath(new URL(".", import.meta.url)); // node 18 has no import.meta.dirname
for (const name of readdirSync(site).filter((each) => /^part-.*\.js$/.test(each)))
    rmSync(join(site, name));
const bundle = (names, more = {}) => build({
    entryPoints: Object.fromEntries(names.map((name) => [name.split("/").pop().replace(".js", ""), join(here, "..", name)])),
    outdir: site, bundle: true, minify: true, format: "esm", target: "es2022", legalComments: "none", logLevel: "warning", ...more,
});
await bundle(["page/page.js"], { splitting: true, chunkNames: "part-[hash]", define: { COURSE: readFileSync(`${site}-course.json`, "utf8") } });
// A Worker is one file, because it starts after that: a part would be fetched after it.
await bundle(["figure_worker.js", "judge_worker.js"], {
    external: ["module", "fs", "path", "url"], // gnuplot's module asks for them in node, not in a page
});
writeServiceWorker(site);
