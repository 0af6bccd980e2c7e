// tools.js - what a page compiles and links besides the answer that is judged: the commands of the judge's plan, for
// another chapter's answer and for programs that draw pictures with answers; cast.c with answers; and the helpers of an
// answer hidden.
import { compileWords, linkWords } from "./compiler.js";
import { Files } from "./wasi.js";

/** The small compiler lacks a function that this run needs. */
export class WholeCompilerNeeded extends Error {}

const FOR_PICTURES = ["--strip-all", "--no-check-features"];
const moduleOf = ({ status, files }) => status === 0 ? new WebAssembly.Module(files.get("linked.wasm")) : undefined;

/**
 * @param {import("./compiler.js").Compiler} compiler
 * @param {Map<string, Uint8Array>} objects what is linked besides answers, by the plan's paths
 */
export function toolsOf(compiler, objects) {
    let program = compiler.small;
    const compiled = new Map(); // source and text -> what compile gave
    const linked = new Map();   // what was linked before: the same objects make the same program

    function run(args, given) {
        const result = program.run({ args, files: new Files(new Map([...compiler.pack, ...given])) });
        if (result.trap !== undefined && program === compiler.small)
            throw new WholeCompilerNeeded();
        return { files: result.files, said: result.stderr, status: result.trap === undefined ? result.status : 1 };
    }
    function linkOf(args, given) {
        const result = run(args, given);
        return { status: result.status, said: result.said, module: moduleOf(result) };
    }
    const option = (words, name) => words[words.indexOf(name) + 1];

    return {
        async takeWhole() {
            program = await (compiler.whole ??= compiler.loadWhole());
        },
        compile(words, files) {
            const source = words.at(-1), text = files.text(source), key = `${source}\n${text}`;
            if (!compiled.has(key)) {
                const { files: left, ...result } = run(compileWords(source), [[source, text]]);
                compiled.set(key, { result, object: left.get("answer.o") });
            }
            const { result, object } = compiled.get(key);
            if (result.status === 0)
                files.put(option(words, "-o"), object.slice());
            return result;
        },
        /** An answer with the answers of earlier chapters, in a handout, which has no reference for those. Nothing for a picture. */
        linkAnswer(words, files) {
            const stem = /([^/]+)\/(answering|alone)$/.exec(option(words, "-o"))?.[1];
            if (stem === undefined)
                return undefined;
            const answers = words.filter((word) => word.endsWith("/answer.o"));
            return linkOf(compiler.answerWords(stem, answers), answers.map((name) => [name, files.get(name)?.slice() ?? new Uint8Array()]));
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
            const result = linkOf(linkWords([...FOR_PICTURES, ...names], false), given.map(([name, bytes]) => [name, bytes.slice()]));
            linked.set(option(words, "-o"), { given: given.map(([name, bytes]) => [name, bytes.slice()]), result });
            return result;
        },
    };
}

const same = (a, b) => a === b || (a.length === b.length && a.every((byte, at) => byte === b[at]));

// ---- a program that casts -------------------------------------------------------------------------

// cast.c linked with a student's answers, which are compiled for pictures. What is not answered, or not right, the
// reference answers.

/**
 * @param {import("./compiler.js").Compiler} compiler
 * @param {Map<string, Uint8Array>} objects those of pictures.pack.gz
 */
export function castLinker(compiler, objects) {
    const stems = [...compiler.pack.keys()].filter((path) => path.startsWith("names/")).map((path) => path.slice(6)).sort();
    const exercises = new Set(stems.flatMap((stem) => compiler.namesOf(stem))), compiled = new Map(); // stem -> {text, object}: the last text

    /** The object of an answer; null if it does not compile. Helpers of two chapters may have one name, so they are hidden. */
    async function objectOf(stem, text) {
        if (compiled.get(stem)?.text !== text) {
            const source = `exercises/${stem}.c`;
            const result = await compiler.run(compileWords(source, false), new Map([...compiler.pack, [source, text]]));
            compiled.set(stem, { text, object: result.status === 0 ? hideHelpers(result.files.get("answer.o"), exercises) : null });
        }
        return compiled.get(stem).object;
    }

    return {
        objectOf,
        /**
         * @param {Object<string, {text: string, used: string[]}>} answers by stem; used: the functions that are taken
         * @param {boolean} [isRace] questions are counted, which takes time
         * @returns {Promise<{module: WebAssembly.Module, yours: string[], reference: string[]}>}
         */
        async link(answers, isRace = false) {
            const given = new Map(), yours = [], reference = [];
            for (const stem of stems) {
                const { text, used = [] } = answers[stem] ?? {}, object = used.length > 0 ? await objectOf(stem, text) : null;
                if (object)
                    given.set(`${stem}.o`, object.slice());
                for (const name of compiler.namesOf(stem))
                    (object && used.includes(name) ? yours : reference).push(name);
            }
            const others = ["link/cast.o", "link/shared.a", ...stems.map((stem) => `link/${stem}-right.o`), ...reference.map((name) => `link/reference/${name}.o`)];
            const words = [...FOR_PICTURES, ...isRace ? ["--wrap=hit_sphere", "--wrap=pixel_ray"] : [], ...given.keys(), ...others];
            const linked = await compiler.run(linkWords(words, true), new Map([...compiler.pack, ...given, ...others.map((path) => [path, objects.get(path).slice()])]));
            if (linked.status !== 0)
                throw new Error(`your answers cannot be linked: ${linked.stderr.split("\n")[0]}`);
            return { module: moduleOf(linked), yours, reference };
        },
    };
}

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
