// cast_worker.js - one Worker of the pool (pool.js): casts tiles of a scene by one program, cast.c with its answers.
import { Files, wasi } from "../wasi.js";

let instance, system, files;

/** A program, and a scene for it. */
function open({ program, scene }) {
    files = new Files(new Map([["scene.nff", scene]]));
    system = wasi({ files });
    instance = new WebAssembly.Instance(program, { wasi_snapshot_preview1: system.imports(program) });
    system.begin(instance);
    instance.exports._initialize();
    check(instance.exports.open_scene());
}

/** What the program said is why there is no picture. */
function check(isGood) {
    if (!isGood)
        throw new Error(new TextDecoder().decode(system.stderr.contents()).trim().split("\n").at(-1).replace(/^scene\.nff:/, "line ") || "there is not enough memory");
}

/** view: ten numbers (cast.c); none: the scene's own. */
function cast({ view, width, height, samples, depth, left, top, right, bottom }) {
    const numbers = () => new Float64Array(instance.exports.memory.buffer, instance.exports.view(), 10);
    if (view)
        numbers().set(view);
    const at = instance.exports.cast(width, height, samples, depth, left, top, right, bottom);
    check(at !== 0);
    return { pixels: new Uint8ClampedArray(instance.exports.memory.buffer, at, 4 * (right - left) * (bottom - top)).slice(), view: [...numbers()] };
}

addEventListener("message", ({ data: { opened, tile } }) => {
    try {
        if (opened)
            open(opened);
        const done = cast(tile);
        postMessage(done, [done.pixels.buffer]);
    } catch (reason) {
        instance = null;
        const isTrap = !(reason instanceof Error) || reason instanceof WebAssembly.RuntimeError || reason instanceof RangeError;
        postMessage({ failed: isTrap ? "your code crashed" : reason.message });
    }
});
