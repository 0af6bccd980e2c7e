// figures.test.mjs - every static figure of the page is, drawn by the page's modules, the one that gnuplot draws in a
// terminal: byte for byte; pictures inside a figure pixel by pixel, because their compression differs. And what a drag
// gives: the handle is where it was put, and a figure of many marks has fewer meanwhile.
//
// Usage: node figures.test.mjs, after make book
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { loadFigures } from "../../../chapters/book/figure.js";

const scratch = mkdtempSync(join(tmpdir(), "figures-"));
process.on("exit", () => rmSync(scratch, { recursive: true }));
const moduleOf = (bytes) => new WebAssembly.Module(bytes);
const figures = await loadFigures({ gnuplot: moduleOf(execFileSync("xz", ["-dc", "build/book/figures/gnuplot.wasm.xz"], { maxBuffer: 1 << 24 })),
    files: JSON.parse(readFileSync("build/book/figures/files.json", "utf8")) });
const programs = new Map();
function programOf(stem) {
    if (!programs.has(stem))
        programs.set(stem, moduleOf(readFileSync(`build/book/programs/${stem}.wasm`)));
    return programs.get(stem);
}

// ---- pictures -----------------------------------------------------------------------------------

const IMAGE = /<image ([^>]*)xlink:href='data:image\/png;base64,([^']*)'\/>(\n<\/g>)?/g;

function compare(drawn, shown, what) {
    const [mine, theirs] = [drawn, shown].map((svg) => [...svg.matchAll(IMAGE)]);
    assert.equal(mine.length, theirs.length, `${what}: pictures`);
    mine.forEach(([, place, base64], i) => {
        assert.equal(place, theirs[i][1], `${what}: the place of picture ${i + 1}`);
        const paths = [base64, theirs[i][2]].map((text, k) => {
            const path = join(scratch, `${k}.png`);
            writeFileSync(path, Buffer.from(text, "base64"));
            return path;
        });
        execFileSync("python3", ["-B", "tests/house/figures/png.py", ...paths], { stdio: "inherit" });
    });
    const [a, b] = [drawn, shown].map((svg) => svg.replace(IMAGE, "<image>").split("\n"));
    const at = a.findIndex((line, i) => line !== b[i]);
    assert.ok(at < 0 && a.length === b.length, `${what}, line ${at + 1}: ${a[at]}\n  the static one: ${b[at]}`);
}

// ---- all figures --------------------------------------------------------------------------------

let count = 0;
const names = new Set();
for (const stem of readdirSync("chapters").filter((each) => /^0[1-7]-/.test(each))) {
    const folder = `build/book/chapters/${stem}/figures`;
    for (const file of readdirSync(folder).filter((each) => each.endsWith(".svg"))) {
        const [, name, narrow, step, dark] = /^(.+?)(-4x3)?(?:-step(\d+))?(-dark)?\.svg$/.exec(file);
        const drawn = figures.draw({ program: programOf(stem), stem, name, theme: dark ? "dark" : "light", shape: narrow ? "4:3" : "16:9", step: Number(step ?? 1000) });
        compare(drawn.svg, readFileSync(`${folder}/${file}`, "utf8"), `${stem}, ${file}`);
        names.add(`${stem} ${name}`);
        count++;
    }
}

// ---- drags --------------------------------------------------------------------------------------

let drags = 0;
const heavy = new Set(["ray-casting", "explain", "image-order", "object-order", "flat-and-shaded"]);
for (const each of names) {
    const [stem, name] = each.split(" "), wanted = { program: programOf(stem), stem, name }, first = figures.draw(wanted);
    first.handles.forEach((handle, i) => {
        if (handle.u === undefined)
            return;
        // Where it is: nothing changes. A key away: something does, and the view is the same.
        const same = figures.drawMoved({ ...wanted, held: first.view, put: { handle: i, u: handle.u, v: handle.v } });
        const now = same.handles[i];
        if (heavy.has(name))
            assert.ok(same.svg.length < 0.7 * first.svg.length, `${each}: ${same.svg.length} bytes while it is dragged, ${first.svg.length} before`);
        assert.ok(Math.hypot(now.u - handle.u, now.v - handle.v) < 5, `${each}: ${handle.words} stays`);
        const moved = [[6, 0], [-6, 0], [0, 6], [0, -6]].map(([du, dv]) =>
            figures.drawMoved({ ...wanted, held: first.view, put: { handle: i, by: { u: handle.u, v: handle.v, du, dv } } }));
        assert.ok(moved.some(({ handles }) => JSON.stringify(handles[i].options) !== JSON.stringify(handle.options)), `${each}: ${handle.words} moves by a key`);
        assert.ok(moved.every(({ view }) => view === first.view), `${each}: the view is held`);
        drags++;
    });
}
// In a figure that does not turn, a point follows the pointer.
const ray = { program: programOf("05-quadratic"), stem: "05-quadratic", name: "ray-sphere" }, before = figures.draw(ray);
for (const [u, v] of [[120, 100], [300, 400], [700, 250]])
    for (const i of [0, 2]) {
        const { handles: { [i]: now } } = figures.drawMoved({ ...ray, held: before.view, put: { handle: i, u, v } });
        assert.ok(Math.hypot(now.u - u, now.v - v) < 3, `${now.words} was put at ${u}, ${v} and is at ${now.u}, ${now.v}`);
    }
assert.throws(() => figures.draw({ ...ray, options: { radius: "-1" } }), /--radius: expected a number greater than 0/);
console.log(`figures: ${count} as the static ones; ${drags} handles dragged`);
