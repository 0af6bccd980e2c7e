// link_cast.js - a student's answers compiled for pictures, without what the judge counts and checks in them; and cast.c
// linked with them. What is not answered, or not right, the reference answers.
import { FLAGS, LIBRARIES, hideHelpers } from "../tools.js";

/**
 * @param {import("../compiler.js").Compiler} compiler
 * @param {Map<string, Uint8Array>} objects those of pictures.pack.gz
 */
export function castLinker(compiler, objects) {
    const stems = [...compiler.pack.keys()].filter((path) => path.startsWith("names/")).map((path) => path.slice(6)).sort();
    const namesOf = Object.fromEntries(stems.map((stem) => [stem, new TextDecoder().decode(compiler.pack.get(`names/${stem}`)).split(/\s+/).filter(Boolean)]));
    const exercises = new Set(Object.values(namesOf).flat()), compiled = new Map(); // stem -> {text, object}: the last text

    /** The object of an answer; null if it does not compile. Helpers of two chapters may have one name, so they are hidden. */
    async function objectOf(stem, text) {
        if (compiled.get(stem)?.text !== text) {
            const source = `exercises/${stem}.c`;
            const result = await compiler.run(["llvm", "clang", "-cc1", ...compiler.flags.draw, "-main-file-name", `${stem}.c`, "-o", "answer.o", "-x", "c", source],
                new Map([...compiler.pack, [source, text]]));
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
                for (const name of namesOf[stem])
                    (object && used.includes(name) ? yours : reference).push(name);
            }
            const others = ["link/cast.o", "link/shared.a", ...stems.map((stem) => `link/${stem}-right.o`), ...reference.map((name) => `link/reference/${name}.o`)];
            const linked = await compiler.run(["llvm", "wasm-ld", "-o", "cast.wasm", "--entry", "_initialize", ...FLAGS, ...isRace ? ["--wrap=hit_sphere", "--wrap=pixel_ray"] : [], "lib/crt1-reactor.o", ...given.keys(), ...others, ...LIBRARIES],
                new Map([...compiler.pack, ...given, ...others.map((path) => [path, objects.get(path).slice()])]));
            if (linked.status !== 0)
                throw new Error(`your answers cannot be linked: ${linked.stderr.split("\n")[0]}`);
            return { module: new WebAssembly.Module(linked.files.get("cast.wasm")), yours, reference };
        },
    };
}
