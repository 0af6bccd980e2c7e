// compiler.test.mjs - the page's compiler: what it makes, what it says, and that cutting it down never changes either.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import test from "node:test";
import { gunzipSync } from "node:zlib";
import { castLinker } from "../../../chapters/book/tools.js";
import { Compiler, Program, load, unpack } from "../../../chapters/book/compiler.js";
import { toolsOf } from "../../../chapters/book/tools.js";
import { Files } from "../../../chapters/book/wasi.js";

const site = new URL("../../../build/book/", import.meta.url), tree = new URL("../../../", import.meta.url);
const fetched = [];
const fetchBytes = async (name) => {
    fetched.push(name);
    return new Response(readFileSync(new URL(name, site)));
};
const shown = [];
const small = await load({ fetchBytes, progress: (done, all) => shown.push([done, all]) });
const whole = new Compiler(small.pack, new Program(await WebAssembly.compile(readFileSync(new URL("build/wasm/compiler/whole.wasm", tree)))));
const stems = readdirSync(new URL("solutions/", tree)).filter((name) => /^0[1-7].*\.c$/.test(name)).map((name) => name.slice(0, -2));
const solution = (stem) => readFileSync(new URL(`solutions/${stem}.c`, tree), "utf8");
const compile = (compiler, stem, text) => compiler.compile({ stem, files: { [`exercises/${stem}.c`]: text } });
const without = (result) => ({ ...result, module: Boolean(result.module), object: result.object && Buffer.from(result.object).toString("base64") });

test("progress ends where it said that it would", () => {
    assert.deepEqual(shown.at(-1)[0], shown.at(-1)[1]);
    assert.ok(shown.every(([done], i) => i === 0 || done > shown[i - 1][0]));
});

test("every solution is compiled without the whole compiler, to the same object", async () => {
    for (const stem of stems) {
        const result = await compile(small, stem, solution(stem));
        assert.equal(result.status, 0, result.messages);
        assert.equal(small.fallbacks, 0, stem);
        assert.deepEqual(without(result), without(await compile(whole, stem, solution(stem))), stem);
        const names = WebAssembly.Module.exports(result.module).map(({ name }) => name);
        assert.ok(names.includes("answer") && names.includes("allow_steps"), names.join());
    }
    assert.ok(!fetched.includes("compiler/whole.wasm.xz"));
});

test("a scene is cast by a program that is linked without the whole compiler", async () => {
    const { link } = castLinker(small, unpack(gunzipSync(readFileSync(new URL("pictures.pack.gz", site))))), of = "05-quadratic";
    const made = await link({ [of]: { text: solution(of), used: ["hit_sphere"] } });
    assert.deepEqual(made.yours, ["hit_sphere"]);
    assert.equal(small.fallbacks, 0);
});

test("a picture is linked without the whole compiler, also if the answers of other chapters are missing", async () => {
    const tools = toolsOf(small, unpack(gunzipSync(readFileSync(new URL("pictures.pack.gz", site)))));
    for (const stem of stems) {
        const { object } = await compile(small, stem, solution(stem));
        const { status, said } = tools.link(["link", "-o", "picture", "answer.o", "link/drawing.o", "link/common.a"], new Files(new Map([["answer.o", object]])));
        assert.equal(status, 0, `${stem}: ${said}`);
    }
});

test("a run leaves nothing for the next one", async () => {
    const [stem] = stems, first = await compile(small, stem, solution(stem));
    await compile(small, stem, "this is not C {{{");
    await compile(small, stem, "#include <stdio.h>\n#define double float\nint x[1000000] = {1};\n");
    assert.deepEqual(without(await compile(small, stem, solution(stem))), without(first));
});

test("after a run the memory is again as the constructors left it", async () => {
    const program = small.small, memory = () => Buffer.from(program.exports.memory.buffer);
    program.begin();
    program.restore(); // the constructors leave something in the stack
    const before = Buffer.from(memory());
    for (const stem of stems) {
        await compile(small, stem, solution(stem));
        assert.ok(memory().compare(before) !== 0, stem);
        program.restore();
        assert.equal(memory().compare(before), 0, stem);
    }
    assert.ok(program.saved.size < 32, `${program.saved.size} pages are saved: most of the memory is constant`);
});

test("a missing semicolon is named at its line", async () => {
    const text = solution("05-quadratic"), at = text.lastIndexOf(";");
    const { module, status, stage, messages } = await compile(small, "05-quadratic", text.slice(0, at) + text.slice(at + 1));
    const line = text.slice(0, at).split("\n").length;
    assert.equal(module, null);
    assert.notEqual(status, 0);
    assert.equal(stage, "compile");
    assert.match(messages, new RegExp(`^exercises/05-quadratic\\.c:${line}:\\d+: error: expected ';'`, "m"));
});

test("a name that nobody defines is the linker's", async () => {
    const text = solution("05-quadratic").replace("{", "{\n    extern double nobody(void);\n    nobody();\n");
    const { module, stage, messages } = await compile(small, "05-quadratic", text);
    assert.equal(module, null);
    assert.equal(stage, "link");
    assert.match(messages, /undefined symbol: nobody/);
});

// Nothing of this is in the texts from which the list of kept functions was made.
const RARE = ["__attribute__((vector_size(16))) int v, w; void f(void) { w = __builtin_shufflevector(v, v, 3, 2, 1, 0); }",
    "int f(int n) { void *to[] = {&&a, &&b}; goto *to[n]; a: return 1; b: return 2; }",
    "_Complex long double f(_Complex long double z) { return z / (1 + z); }",
    "int f(int n) { int g __attribute__((cleanup(h))); return ({ n + 1; }); }",
    "_BitInt(77) f(_BitInt(77) a) { return a * a / 3; }", "__asm__(\".functype g () -> ()\");",
    "int f(int n) { return __builtin_choose_expr(1, _Generic(n, int: __builtin_bswap32), 0)(n); }"];

test("a text that the cut compiler cannot handle gets the result of the whole one", async () => {
    const before = small.fallbacks;
    for (const text of RARE)
        assert.deepEqual(without(await compile(small, "05-quadratic", text)), without(await compile(whole, "05-quadratic", text)), text);
    assert.ok(small.fallbacks > before, "one of them should have needed the whole compiler");
    assert.equal(fetched.filter((name) => name === "compiler/whole.wasm.xz").length, 1);
});
