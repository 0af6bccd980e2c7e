// verdicts.mjs - the page's verdicts are the terminal's, word for word.
//
//   node verdicts.mjs SITE ROOT    ROOT: the toolkit, or a handout, built; STEMS: of which chapters; COUNT: wrong answers of each
//
// The page compiles, links and judges by itself; in the terminal build/course does. Blanks and right answers need no whole
// compiler.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import test from "node:test";
import { partsOf } from "../../../chapters/book/judge.js";
import { WholeCompilerNeeded } from "../../../chapters/book/tools.js";
import { openSite } from "./in_node.mjs";
import { FOR_A_TERMINAL } from "./site.mjs";

const [site, root] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "verdicts-")), terminal = join(folder, "tree");
process.on("exit", () => rmSync(folder, { recursive: true }));
const stems = readdirSync("solutions").filter((name) => /^\d\d-.*\.c$/.test(name)).map((name) => name.slice(0, -2));
const blanks = Object.fromEntries(stems.map((stem) => [stem, readFileSync(`build/blanks/${stem}.c`, "utf8")]));
const right = Object.fromEntries(stems.map((stem) => [stem, readFileSync(`solutions/${stem}.c`, "utf8")]));

// ---- the terminal: a tree of links, with exercises/ and build/exercises/ of its own ---------------------

const own = [["exercises", (name) => name.endsWith(".c")], ["build", (name) => name === "exercises"]];
for (const [at, isOwn] of [[".", (name) => name[0] === "." || own.some(([other]) => other === name)], ...own]) {
    mkdirSync(join(terminal, at), { recursive: true });
    for (const name of readdirSync(join(root, at)))
        if (!isOwn(name))
            symlinkSync(resolve(root, at, name), join(terminal, at, name));
}
cpSync(join(root, "build/exercises/verdict/plan"), join(terminal, "build/exercises/verdict/plan"));
function inTerminal(stem, sources) {
    for (const name of ["figures", "so-far", "gallery"])
        rmSync(join(terminal, "build/exercises", name), { recursive: true, force: true });
    for (const name of readdirSync(join(terminal, "build/exercises/verdict")))
        if (name !== "plan")
            rmSync(join(terminal, "build/exercises/verdict", name), { recursive: true });
    for (const [name, text] of Object.entries(sources))
        writeFileSync(join(terminal, `exercises/${name}.c`), text);
    return spawnSync("build/course", ["exercises", "build/exercises/verdict/plan", stem],
        { cwd: terminal, encoding: "utf8", env: { PATH: process.env.PATH, COLUMNS: "" } }).stdout;
}

// ---- the page --------------------------------------------------------------------------------------------

const { tools, newJudge } = await openSite(site);
let isWhole = false;
async function inPage(stem, sources, what, how = {}) {
    try {
        return (await newJudge().draw({ stem, sources, ...how }, async (words, all) => tools.link(words, all))).text;
    } catch (error) {
        if (!(error instanceof WholeCompilerNeeded) || isWhole)
            throw error;
        assert.doesNotMatch(what, /^(all blank|right)/, "the whole compiler is needed");
        isWhole = true;
        await tools.takeWhole();
        return inPage(stem, sources, what, how);
    }
}

// ---- both ------------------------------------------------------------------------------------------------

// The compilers' own words differ.
const told = (text) => text.replace(/ error: .*/, " error").replace(/^exercises\/.*: warning: .*\n(.+\n)*/gm, "");
const compare = (stem, what, sources) => test(`${stem}, ${what}`, async () => {
    const ours = told(inTerminal(stem, { ...blanks, ...sources })), theirs = told(await inPage(stem, { ...blanks, ...sources }, what));
    assert.equal(theirs, ours);
    assert.ok(ours.length > 50, ours);
    // As parts for a page: the same words, without what belongs to a terminal.
    const plain = (words) => words.replace(/[\s~]|[.:]$/g, "").toLowerCase(), said = plain(theirs);
    const parts = partsOf(await inPage(stem, { ...blanks, ...sources }, what, { web: true })).filter(({ kind }) => kind !== "compiler" && kind !== "printed");
    assert.deepEqual(parts.map(({ words }) => words).filter((words) => !said.includes(plain(words))), []);
    assert.ok(parts.some(({ words }) => words.length > 10), JSON.stringify(parts));
    for (const { words } of parts)
        assert.doesNotMatch(words, FOR_A_TERMINAL);
});

/** COUNT wrong answers: in each, another operator of the right answer is the opposite one. */
function wrong(text, count) {
    const opposite = { " + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ", " < ": " > ", " > ": " < " };
    const places = [...text.matchAll(/^ .*?( [-+*/<>] )/gm)].filter(([line]) => !line.includes("//")).map((each) => [each.index + each[0].length - 3, each[1]]);
    const step = Math.max(1, places.length / count);
    return Array.from({ length: Math.min(count, places.length) }, (_, i) => places[Math.floor(i * step)])
        .map(([at, operator]) => text.slice(0, at) + opposite[operator] + text.slice(at + 3));
}
const before = (stem) => Object.fromEntries(Object.entries(right).filter(([other]) => other < stem));
for (const stem of (process.env.STEMS ?? "02-cameras 05-quadratic 06-ray-casting").split(" ")) {
    await compare(stem, "all blank", {});
    await compare(stem, "right", { ...before(stem), [stem]: right[stem] });
    await compare(stem, "right, on blanks", { [stem]: right[stem] });
    await compare(stem, "right, on what does not compile", { ...before(stem), "01-corners": "not C\n", [stem]: right[stem] });
    await compare(stem, "does not compile", { ...before(stem), [stem]: right[stem].replace(/;\n}/, "\n}") });
    await compare(stem, "helpers of one name", { ...before(stem), "01-corners": `${right["01-corners"]}\nint helper(void);\nint helper(void) { return 1; }\n`,
        [stem]: `${right[stem]}\nint helper(void);\nint helper(void) { return 2; }\n` });
    for (const [i, text] of wrong(right[stem], Number(process.env.COUNT) || 10).entries())
        await compare(stem, `wrong answer ${i}`, { ...before(stem), [stem]: text });
}

// Answers to the first exercise that end, or do not, in every way.
const bodies = {
    "an endless loop": "for (volatile int i = 0;;) i++;",
    "no end of calls": "static int depth; vec3 below = depth++ < 0 ? c.origin : upper_left(c); return below + c.up;",
    "a read of address 0": "vec3 *volatile none = 0; return *none;",
    "a write to address 0": "vec3 *volatile none = 0; *none = c.origin; return c.origin;",
    "the end of an array": "double a[3] = {0}; for (int i = 0; i <= 3; i++) a[i] = i; return vec3_of(a[0], a[1], a[2]);",
    "a division by zero": "volatile int none = 0, one = 1; return c.origin * (one / none);",
    "exit": "exit(3);",
    "abort": "abort();",
    "an unset result": "vec3 v; v[0] = 1; return v;",
    "sums without a beginning": "double x, y, z; x += c.origin[0]; y += c.origin[1]; z += c.origin[2]; return vec3_of(x, y, z);",
    "a color that does not begin at black": "vec3 sum; for (int i = 0; i < 3; i++) sum += c.origin; return sum;",
    "a helper that sums up without a beginning": "return total(c);",
    "the same where another helper has left zeros": "vec3 sum = black(c); for (int i = 0; i < 1; i++) sum += total(c); return sum;",
    "an int that was never set": "int i; return i == 0 ? c.origin : i * c.right;",
    "a bool that was never set": "bool far; if (c.distance > 1) far = true; return far ? c.right : c.up;",
    "a loop up to v[3]": "double sum = 0; for (int i = 0; i <= 3; i++) sum += c.up[i]; return sum * c.right;",
    "printed words": 'printf("hello %g\\n", c.width); return c.origin;',
    "too many printed words": 'for (;;) { printf("hello %g\\n", c.width); }',
    "another answer that is not answered": "return image_plane_vector(c, 0, 1);",
};
const helper = (name, sum) => `static vec3 ${name}(Camera c)\n{\n    ${sum}\n    return sum;\n}\n`;
const helpers = helper("black", "vec3 sum = {0, 0, 0}; for (int i = 0; i < 3; i++) sum[i] *= c.origin[i];") +
  helper("total", "vec3 sum; for (int i = 0; i < 3; i++) sum[i] += c.origin[i];");
const blank = blanks["01-corners"].replace("vec3 upper_left(", `${helpers}$&`).replace("#include", "#include <stdio.h>\n#include <stdlib.h>\n#include");
for (const [what, body] of Object.entries(bodies))
    await compare("01-corners", what, { "01-corners": blank.replace(/(vec3 upper_left\(Camera c\)\n\{\n)[^}]*/, (_, start) => `${start}    ${body}\n`) });
