// tools.js - the commands of the judge's plan that a page runs at once: compiling another chapter's answer, and linking
// the programs that draw pictures with answers; and, in a handout, hiding the helpers of an answer.
import { Files } from "./wasi.js";

/** The small compiler lacks a function that this run needs. */
export class WholeCompilerNeeded extends Error {}

export const LIBRARIES = ["lib/common.a"].concat(["signal", "mman", "process-clocks", "getpid"].map((name) => `lib/libwasi-emulated-${name}.a`),
    ["lib/libm.a", "lib/libc.a", "lib/builtins.a"]);
export const FLAGS = ["--gc-sections", "--strip-all", "--no-check-features", "--stack-first", "-z", "stack-size=1048576", "--max-memory=536870912"];

/**
 * @param {import("./compiler.js").Compiler} compiler
 * @param {Map<string, Uint8Array>} objects what is linked besides answers, by the plan's paths
 */
export function toolsOf(compiler, objects) {
    let program = compiler.small;
    const compiled = new Map(); // source and text -> what compile gave
    const linked = new Map();   // what was linked before: the same objects make the same program

    function run(args, files) {
        const result = program.run({ args: ["llvm", ...args], files: new Files(files) });
        if (result.trap !== undefined && program === compiler.small)
            throw new WholeCompilerNeeded();
        return { ...result, said: result.stderr, status: result.trap === undefined ? result.status : 1 };
    }
    const option = (words, name) => words[words.indexOf(name) + 1];

    return {
        async takeWhole() {
            program = await (compiler.whole ??= compiler.loadWhole());
        },
        compile(words, files) {
            const source = words.at(-1), text = files.text(source), key = `${source}\n${text}`;
            if (!compiled.has(key)) {
                const result = run(["clang", "-cc1", ...compiler.flags.compile, "-main-file-name", source.split("/").pop(), "-o", "answer.o", "-x", "c", source],
                    new Map([...compiler.pack, [source, text]]));
                compiled.set(key, { status: result.status, said: result.said, object: result.files.get("answer.o") });
            }
            const { object, ...result } = compiled.get(key);
            if (result.status === 0)
                files.put(option(words, "-o"), object.slice());
            return result;
        },
        /** An answer with the answers of earlier chapters, in a handout, which has no reference for those. Nothing for a picture. */
        linkAnswer(words, files) {
            const stem = /([^/]+)\/(answering|alone)$/.exec(option(words, "-o"))?.[1];
            if (stem === undefined)
                return undefined;
            const objects = words.filter((word) => word.endsWith("/answer.o"));
            const result = run(["wasm-ld", ...compiler.linkWords(stem, objects)],
                new Map([...compiler.pack, ...objects.map((name) => [name, files.get(name)?.slice() ?? new Uint8Array()])]));
            return { status: result.status, said: result.said, module: result.status === 0 ? new WebAssembly.Module(result.files.get("answer.wasm")) : undefined };
        },
        link(words, files) {
            const names = words.filter((word) => /\.[oa]$/.test(word) && word !== "link/common.a"); // that is in the pack
            const given = names.map((name) => [name, files.get(name) ?? objects.get(name)]);
            const missing = given.find(([, bytes]) => bytes === undefined);
            if (missing)
                return { status: 1, said: `${missing[0]}: there is no such object\n` };
            const before = linked.get(option(words, "-o"));
            if (before && before.given.length === given.length && before.given.every(([name, bytes], at) => name === given[at][0] && same(bytes, given[at][1])))
                return before.result;
            const result = run(["wasm-ld", "-o", "program.wasm", ...FLAGS, "lib/crt1-command.o", ...names, ...LIBRARIES],
                new Map([...compiler.pack, ...given.map(([name, bytes]) => [name, bytes.slice()])]));
            const made = { status: result.status, said: result.said, module: result.status === 0 ? new WebAssembly.Module(result.files.get("program.wasm")) : undefined };
            linked.set(option(words, "-o"), { given: given.map(([name, bytes]) => [name, bytes.slice()]), result: made });
            return made;
        },
    };
}

const same = (a, b) => a === b || (a.length === b.length && a.every((byte, at) => byte === b[at]));

// ---- hiding helpers -------------------------------------------------------------------------------

// Hides all but the exercises in a compiled answer, because helpers of two chapters may have one name.
// In the terminal objcopy --keep-global-symbols does it, which knows no WebAssembly objects.
//
// The symbols are in the section 'linking' of the object (WebAssembly/tool-conventions, Linking.md).
const WEAK = 1, LOCAL = 2, UNDEFINED = 0x10, EXPLICIT_NAME = 0x40;
const FUNCTION = 0, DATA = 1, SECTION = 3, SYMBOL_TABLE = 8;

/**
 * @param {Uint8Array} object
 * @param {Set<string>} kept the names that stay global
 * @returns {Uint8Array} a copy
 */
export function hideHelpers(object, kept) {
    const bytes = object.slice(), text = new TextDecoder();
    let at = 8;
    const number = () => {
        let value = 0, shift = 0, byte;
        do {
            byte = bytes[at++];
            value += (byte & 0x7f) * 2 ** shift;
            shift += 7;
        } while (byte & 0x80);
        return value;
    };
    const name = () => { const size = number(); return text.decode(bytes.subarray(at, at += size)); };
    function symbol() {
        const kind = bytes[at++], place = at, flags = number(), isDefined = !(flags & UNDEFINED);
        if (kind === SECTION) { number(); return; }
        let named;
        if (kind === DATA) {
            named = name();
            if (isDefined) { number(); number(); number(); }
        } else {
            number();
            if (isDefined || flags & EXPLICIT_NAME)
                named = name();
        }
        // Both flags are in the first byte of their number.
        if (isDefined && (kind === FUNCTION || kind === DATA) && !kept.has(named))
            bytes[place] = bytes[place] & ~WEAK | LOCAL;
    }
    while (at < bytes.length) {
        const id = bytes[at++], size = number(), end = at + size;
        if (id === 0 && name() === "linking") {
            number(); // the version
            while (at < end) {
                const kind = bytes[at++], length = number(), after = at + length;
                if (kind === SYMBOL_TABLE)
                    for (let count = number(); count > 0; count--)
                        symbol();
                at = after;
            }
        }
        at = end;
    }
    return bytes;
}
