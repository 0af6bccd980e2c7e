// compiler.js - the C compiler of the page: clang and its linker, as WebAssembly.
//
// A text becomes a module in two runs of one program: 'clang -cc1' makes an object of it, 'wasm-ld' links that
// object with the code that answers the judge's calls. Headers and everything that is linked are in the
// pack, which make writes (site/write_pack.mjs).
//
// The compiler is cut down for size (compiler/cut.js). A run that enters a function which was cut away
// traps; then the whole compiler is fetched, and that run is made again with it.
import xz from "xz-decompress";
import { Files, PAGE, clear, isEmpty, start, trapOf, wasi } from "./wasi.js";

const LANGUAGE = ["-triple", "wasm32-unknown-wasip1", "-emit-obj", "-disable-free", "-fgnuc-version=4.2.1",
    "-std=c11", "-D", "_DEFAULT_SOURCE", "-ffp-contract=off", "-O0",
    "-I", ".", "-resource-dir", "clang", "-internal-isystem", "clang/include", "-internal-isystem", "include",
    "-Wall", "-Wextra", "-Wno-psabi", "-Wno-unused-parameter",
    "-Wno-missing-field-initializers", "-Wno-missing-braces", "-Wno-sign-compare",
    "-Werror=return-type", "-Werror=implicit-function-declaration", "-include", "weak.h", "-ffunction-sections"];
const CHECKS = ["-fsanitize=array-bounds,local-bounds,null", "-fsanitize-trap=array-bounds,local-bounds",
    "-fsanitize-coverage-type=3", "-fsanitize-coverage-no-prune", "-fsanitize-coverage-trace-pc"];
const LIBRARIES = ["common.a", ...["signal", "mman", "process-clocks", "getpid"].map((name) => `libwasi-emulated-${name}.a`), "libm.a", "libc.a", "builtins.a"];

/** An answer's compilation; isChecked: the judge counts its steps and checks its pointers, which a picture does not need. */
export const compileWords = (source, isChecked = true) => ["llvm", "clang", "-cc1", ...LANGUAGE, ...isChecked ? CHECKS : [],
    "-main-file-name", source.split("/").pop(), "-o", "answer.o", "-x", "c", source];
/** A link; stays: the program is called again and again, instead of once. */
export const linkWords = (words, stays) => ["llvm", "wasm-ld", "-o", "linked.wasm", ...stays ? ["--entry", "_initialize", "lib/crt1-reactor.o"] : ["lib/crt1-command.o"],
    "--gc-sections", "--stack-first", "-z", "stack-size=1048576", "--max-memory=536870912", ...words,
    ...LIBRARIES.map((name) => `lib/${name}`)];

const SMALL = "compiler/small.wasm.xz", WHOLE = "compiler/whole.wasm.xz", PACK = "compiler/pack.xz";
// An answer that is compiled while nobody waits.
const FIRST = "05-quadratic", WARMING = `#include "exercises/${FIRST}.h"
#include <math.h>
Roots quadratic_roots(Quadratic q)
{
    Roots roots = {0};
    double d = q.b * q.b - 4 * q.a * q.c, values[2] = {-1, 1};
    if (d < 0 || q.a == 0)
        return roots;
    for (int i = 0; i < 2; i++)
        roots.t[roots.count++] = (-q.b + values[i] * sqrt(d)) / (2 * q.a);
    return roots;
}
`;

/**
 * A program that is started many times in one instance: each run begins with the memory that the program's
 * constructors left, because making a fresh instance and running them takes as long as compiling an answer.
 */
export class Program {
    constructor(module) { this.module = module; }

    /** A fresh instance, and the memory that its constructors leave. */
    begin() {
        /** @type {Record<string, Function>} */
        const calls = {};
        for (const { name } of WebAssembly.Module.imports(this.module))
            calls[name] = (...given) => this.calls[name](...given);
        /** @type {any} */
        const exports = this.exports = new WebAssembly.Instance(this.module, { wasi_snapshot_preview1: calls }).exports;
        this.stack = exports.stack.value;
        // What _start does before it asks for its arguments is done first; the constructors need it.
        const system = wasi({});
        system.begin(exports);
        const before = new Error("asked for the arguments");
        this.calls = { ...system.calls, args_sizes_get() { throw before; } };
        try { exports._start(); } catch (error) {
            if (error !== before)
                throw error;
        }
        exports.stack.value = this.stack;
        this.calls = system.calls;
        exports.constructors();
        exports.stack.value = this.stack;
        // The stack is below, then what no run changes; the heap is empty but for its last words.
        const { buffer } = exports.memory;
        this.size = buffer.byteLength;
        this.changing = Math.floor(exports.data.value / PAGE);
        this.saved = new Map();
        for (let page = this.changing; page < this.size / PAGE; page++)
            if (!isEmpty(buffer, page))
                this.saved.set(page, new Uint8Array(buffer, page * PAGE, PAGE).slice());
    }

    /** The memory is again as begin() left it. */
    restore() {
        const { buffer } = this.exports.memory;
        clear(buffer, 0, this.stack / PAGE);
        for (let page = this.changing; page < this.size / PAGE; page++) {
            const bytes = this.saved.get(page);
            if (bytes)
                new Uint8Array(buffer, page * PAGE, PAGE).set(bytes);
            else
                clear(buffer, page, page + 1);
        }
    }

    /** As run in wasi.js. */
    run({ args, files }) {
        if (!this.exports || this.exports.memory.buffer.byteLength !== this.size)
            this.begin();
        this.restore();
        this.exports.stack.value = this.stack;
        const system = wasi({ args, files }), result = { files };
        system.begin(this.exports);
        this.calls = system.calls;
        try {
            result.status = start(this.exports);
        } catch (error) {
            Object.assign(result, { trap: trapOf(error), error });
        }
        return { ...result, stdout: system.said(), stderr: system.errors() };
    }
}

/**
 * The files of a pack: the length of a JSON text, that text {path: size}, and the files' bytes.
 * @param {Uint8Array} bytes
 * @returns {Map<string, Uint8Array>}
 */
export function unpack(bytes) {
    const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true), files = new Map();
    let at = 4 + length;
    for (const [path, size] of Object.entries(JSON.parse(new TextDecoder().decode(bytes.subarray(4, at))))) {
        files.set(path, bytes.subarray(at, at + size));
        at += size;
    }
    return files;
}

/**
 * @param {{fetchBytes: (name: string) => Promise<Response|Uint8Array>, progress?: (done: number, all: number) => void,
 *          onFetched?: () => void}} given
 *        fetchBytes: a file of the site; progress: compressed bytes, of the sizes that the pack's neighbours state;
 *        onFetched: called when all of them are there
 * @returns {Promise<Compiler>} ready for the first answer
 */
export async function load({ fetchBytes, progress = () => {}, onFetched = () => {} }) {
    const first = fetchBytes(SMALL);
    first.catch(() => {}); // a failure is told when it is read
    const sizes = await new Response(body(await fetchBytes("compiler/sizes.json"))).json();
    const all = sizes[SMALL] + sizes[PACK];
    let done = 0, startPack;
    const count = (size) => {
        progress(done += size, all);
        if (done > 0.95 * sizes[SMALL])
            startPack();
    };
    const counted = async (response, hear) => body(await response).pipeThrough(new TransformStream({
        transform(part, to) { hear(part.length); to.enqueue(part); },
    }));
    const compiled = async (bytes) => WebAssembly.compileStreaming(
        new Response(new xz.XzReadableStream(await bytes), { headers: { "content-type": "application/wasm" } }));
    // The compiler first, because there is most to do with it: that is done while the pack comes.
    const compressed = new Promise((resolve) => { startPack = resolve; })
        .then(async () => new Response(await counted(fetchBytes(PACK), count)).arrayBuffer());
    compressed.then(onFetched, () => {}); // a failure is told when the pack is unpacked
    const small = new Program(await compiled(counted(first, count)));
    small.begin();
    const pack = unpack(new Uint8Array(await new Response(new xz.XzReadableStream(body(await compressed))).arrayBuffer()));
    // The decoder's memory is as large as what it looks back on. It is made again for the whole compiler.
    Object.assign(xz.XzReadableStream, { _moduleInstance: undefined, _moduleInstancePromise: undefined });
    return new Compiler(pack, small, async () => new Program(await compiled(counted(fetchBytes(WHOLE), () => {}))));
}

const body = (answer) => answer instanceof Response ? answer.body : new Response(answer).body;

export class Compiler {
    /** How often an answer needed the whole compiler. */
    fallbacks = 0;
    warmed = null;
    whole = null;

    constructor(pack, small, loadWhole) {
        this.pack = pack;
        this.small = small;
        this.loadWhole = loadWhole;
    }

    /** An engine makes code of a function when it is first called: a student should not wait for that. */
    async warm() {
        this.warmed ??= this.compile({ stem: FIRST, files: { [`exercises/${FIRST}.c`]: WARMING } });
        await this.warmed;
    }

    /** The run of the small compiler, or of the whole one if that traps. */
    async run(args, files) {
        const again = new Map(files), result = this.small.run({ args, files: new Files(files) });
        if (result.trap === undefined)
            return result;
        this.fallbacks++;
        this.whole ??= this.loadWhole();
        return (await this.whole).run({ args, files: new Files(again) });
    }

    /**
   * Compiles and links an answer.
   * @param {{stem: string, files: Object<string, string>}} given files: at least exercises/STEM.c
   * @returns {Promise<{module: WebAssembly.Module|null, object?: Uint8Array, status: number, stage: string,
   *          messages: string}>} messages: what the compiler said, or the linker if that failed
   */
    async compile({ stem, files }) {
        const compiled = await this.run(compileWords(`exercises/${stem}.c`), new Map([...this.pack, ...Object.entries(files)]));
        if (compiled.status !== 0)
            return { module: null, ...failed(compiled, "compile") };
        const object = compiled.files.get("answer.o"), linked = await this.link(stem, object);
        return linked.module ? { ...linked, object, stage: "compile", messages: compiled.stderr } : { ...linked, object };
    }

    /** The exercises of a chapter; of a handout, those before it too. */
    namesOf(stem) { return new TextDecoder().decode(this.pack.get(`names/${stem}`)).split(/\s+/).filter(Boolean); }

    /**
   * The words of the link of a chapter's answer with what answers the judge's calls. Calls of an exercise, in the answer
   * too, go through chapters/book/instead/answering.c. objects: the answer, and the answers that it calls
   */
    answerWords(stem, objects = ["answer.o"]) {
        return linkWords(["--export=__stack_pointer", "--strip-debug", ...objects, ...this.namesOf(stem).map((name) => `--wrap=${name}`), `link/${stem}.o`], true);
    }

    /** @returns as compile */
    async link(stem, object) {
        const linked = await this.run(this.answerWords(stem), new Map([...this.pack, ["answer.o", object]]));
        if (linked.status !== 0)
            return { module: null, ...failed(linked, "link") };
        // Not by WebAssembly.compile: in WebKit that waits until all threads are done with making the compiler faster.
        return { module: new WebAssembly.Module(linked.files.get("linked.wasm")), status: 0, stage: "link", messages: linked.stderr };
    }
}

/** Messages are those of a run that ended, else how the compiler itself ended. */
const failed = ({ status = 1, stderr, trap }, stage) => ({ status, stage, messages: trap ? `${stderr}the compiler ended: ${trap}\n` : stderr });
