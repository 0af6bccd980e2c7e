// cast_worker.js - one Worker of the pool (pool.js): casts tiles of a scene by one program, cast.c with its answers.
import { Exit, Files, wasi } from "../wasi.js";

let exports = null, system, files, opened = {};

/** A program, and a scene for it. */
function open({ program, scene }) {
    if (program !== opened.program || exports === null) {
        system = wasi({ files: files = new Files() });
        exports = system.open(program);
        exports._initialize();
    }
    opened = { program, scene };
    files.put("scene.nff", scene);
    check(exports.open_scene());
}

const lastWords = () => system.errors().trim().split("\n").at(-1).replace(/^scene\.nff:/, "line ") || "there is not enough memory";
/** What the program said is why there is no picture. */
function check(isGood) {
    if (!isGood)
        throw new Error(lastWords());
}

/** view: ten numbers (cast.c); none: the scene's own. explained: a pixel, {column, row}, instead of a tile. */
function cast({ view, width, height, samples, depth, left, top, right, bottom, caster, mistake, explained, isRace }) {
    const numbers = () => new Float64Array(exports.memory.buffer, exports.view(), 10);
    if (view)
        numbers().set(view);
    exports.choose_mistake?.(mistake);
    if (explained) {
        system.stdout.resize(0);
        check(exports.explain_pixel(width, height, depth, explained.column, explained.row));
        return { story: system.said() };
    }
    new Uint8Array(exports.memory.buffer, exports.caster(), 40).set(new TextEncoder().encode(`${caster}\0`));
    const counts = isRace && exports.begin_race(width, height), start = performance.now();
    check(counts !== 0);
    const at = exports.cast(width, height, samples, depth, left, top, right, bottom);
    check(at !== 0);
    const took = performance.now() - start, size = width * height, { buffer } = exports.memory;
    const race = isRace && { took, counts: new Uint32Array(buffer, counts, size).slice(), painted: new Float32Array(buffer, counts + 4 * size, size).slice() };
    return { pixels: new Uint8ClampedArray(buffer, at, 4 * (right - left) * (bottom - top)).slice(), view: [...numbers()], race };
}

addEventListener("message", ({ data: { program, scene, tile } }) => {
    try {
        if (program || scene)
            open({ program: program ?? opened.program, scene: scene ?? opened.scene });
        const done = cast(tile);
        postMessage(done, { transfer: done.pixels ? [done.pixels.buffer] : [] });
    } catch (reason) {
        exports = null;
        const isTrap = !(reason instanceof Error) || reason instanceof WebAssembly.RuntimeError || reason instanceof RangeError;
        postMessage({ failed: isTrap ? "your code crashed" : reason instanceof Exit ? lastWords() : reason.message });
    }
});
