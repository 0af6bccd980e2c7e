// in_node.mjs - the page's compiler and judge in node: what a page does, without a browser.
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { gunzipSync } from "node:zlib";
import { load, unpack } from "../../../chapters/book/compiler.js";
import { createJudge } from "../../../chapters/book/judge.js";
import { toolsOf } from "../../../chapters/book/tools.js";

export const opened = (path) => path.endsWith(".gz") ? gunzipSync(readFileSync(path))
    : path.endsWith(".xz") ? execFileSync("xz", ["-dc", path], { maxBuffer: 1 << 28 }) : readFileSync(path);

/** Of a site: tools, and newJudge(), a judge of a student who has answered nothing yet. */
export async function openSite(site) {
    const compiler = await load({ fetchBytes: async (name) => new Uint8Array(readFileSync(join(site, name))) });
    const pictures = unpack(opened(join(site, "pictures.pack.gz"))), tools = toolsOf(compiler, pictures);
    const program = (name) => new WebAssembly.Module(readFileSync(join(site, `programs/${name}.wasm`)));
    const modules = { course: program("course"), judge: program("judge") };
    const json = (name) => existsSync(join(site, name)) ? Object.entries(JSON.parse(readFileSync(join(site, name), "utf8"))) : [];
    const tables = readdirSync(join(site, "tables")).map((name) => [`tables/${name.slice(0, -3)}`, opened(join(site, "tables", name))]);
    const files = [...json("tree/files.json"), ...json("figures/files.json"), ...[...pictures].filter(([path]) => /\.(png|nff)$/.test(path)), ...tables];
    return { tools, newJudge: () => createJudge({ modules, files: new Map(files), compile: tools.compile, link: tools.linkAnswer }) };
}
