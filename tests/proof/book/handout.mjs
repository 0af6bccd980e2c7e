// handout.mjs - the site for a class whose solutions stay private: no file of it has anything of a solution.
//
//   node handout.mjs SITE HANDOUT WASM    HANDOUT: unpacked; WASM: what the site is linked from
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { unpack } from "../../../chapters/book/compiler.js";
import { opened } from "./in_node.mjs";

const [site, handout, wasm] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "handout-"));
process.on("exit", () => rmSync(folder, { recursive: true }));
const filesIn = (root) => readdirSync(root, { recursive: true }).map((name) => join(root, name)).filter((path) => statSync(path).isFile());

// ---- nothing of a solution ---------------------------------------------------------------------------

const solutions = readdirSync("solutions").filter((name) => /^\d\d-.*\.c$/.test(name));
const exercises = new Set(readFileSync("build/exercises.names", "utf8").trim().split("\n"));

// Names of helpers and lines of comments, if the handout has them nowhere.
const published = filesIn(handout).filter((path) => !path.includes("/build/") && /\.(c|h|md|hints|gp|def|mk|table)$/.test(path))
    .map((path) => readFileSync(path, "utf8")).join("\n");
const secrets = solutions.flatMap((name) => {
    const text = readFileSync(join("solutions", name), "utf8");
    const helpers = [...text.matchAll(/^static [^;=()]*?\b(\w+_\w+)\(/gm)].map(([, helper]) => helper);
    const comments = [...text.matchAll(/\/\/ (.{20,})$/gm)].map(([, words]) => words);
    return [...helpers, ...comments].filter((each) => !published.includes(each));
});
assert.ok(secrets.length > 10, `only ${secrets.length} helpers and comments of solutions are looked for`);
for (const path of filesIn(site)) {
    const bytes = opened(path);
    for (const secret of secrets)
        assert.ok(!bytes.includes(secret), `${path} has '${secret}' of a solution`);
}

// An object that is linked with answers defines no exercise, under any name.
for (const name of ["pictures.pack.gz", "compiler/pack.xz"])
    for (const [path, bytes] of unpack(opened(join(site, name)))) {
        assert.ok(!/right|reference|solution/.test(path), `${name} has ${path}`);
        if (!/^link\/.*\.[oa]$|common\.a$/.test(path))
            continue;
        const object = join(folder, path.replaceAll("/", "-"));
        writeFileSync(object, bytes);
        for (const defined of execFileSync("llvm-nm", ["--defined-only", "--format=just-symbols", object], { encoding: "utf8" }).split("\n"))
            assert.ok(!exercises.has(defined.replace(/^(lent|answer|reference|right)_/, "")), `${name}, ${path} defines ${defined}`);
    }
assert.ok(!readdirSync(join(site, "programs")).some((name) => /^\d\d-/.test(name)), "a chapter's program is in the site");

// Programs have no names; but they are linked from objects, and each says of which files it was made.
const made = filesIn(wasm).filter((path) => path.endsWith(".d") && !path.includes("/ray-casting/"));
assert.ok(made.length > 50, `only ${made.length} objects say of which files they were made`);
for (const path of made)
    assert.ok(!/\b(solutions\/|tests\/\d\d-(?!\S*\/laws\.)|tests\/judge\/reference\/)/.test(readFileSync(path, "utf8")), `${path}: a solution, or a test`);
