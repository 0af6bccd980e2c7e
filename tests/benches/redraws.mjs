// redraws.mjs - how much of a processor it takes to redraw each figure of the page while a handle of it is dragged: the
// least of several drags, in milliseconds, so that other programs matter little. In node, which has Chromium's engine;
// the browser's own part, putting the SVG into the page, is not in it.
//
// Usage: node tests/benches/redraws.mjs [FIGURE...], after make book
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { loadFigures } from "../../chapters/book/figure.js";

const only = process.argv.slice(2), site = "build/book", TIMES = 12;
const moduleOf = (bytes) => new WebAssembly.Module(bytes);
const figures = await loadFigures({ gnuplot: moduleOf(execFileSync("xz", ["-dc", `${site}/figures/gnuplot.wasm.xz`], { maxBuffer: 1 << 24 })),
    finish: moduleOf(readFileSync(`${site}/programs/finish_figure.wasm`)), files: JSON.parse(readFileSync(`${site}/figures/files.json`, "utf8")) });

function milliseconds(work) {
    let least = Infinity;
    for (let i = 0; i < TIMES; i++) {
        const before = process.cpuUsage();
        work(i);
        const { user, system } = process.cpuUsage(before);
        least = Math.min(least, (user + system) / 1000);
    }
    return least;
}

console.log("figure                  dragged   whole    (30 redraws a second: 33 ms)");
for (const stem of readdirSync("chapters").filter((each) => /^0[1-7]-/.test(each))) {
    const program = moduleOf(readFileSync(`${site}/programs/${stem}.wasm`));
    const names = readdirSync(`chapters/${stem}/figures`).map((file) => /^([a-z0-9-]+?)(-4x3|-dark|-step\d+)*\.svg$/.exec(file)?.[1]);
    for (const name of new Set(names.filter((each) => each && (only.length === 0 || only.includes(each))))) {
        const wanted = { program, stem, name }, first = figures.draw(wanted);
        const handle = first.handles.findIndex(({ u }) => u !== undefined);
        const put = (i) => ({ handle, u: first.handles[handle].u + 10 * Math.sin(i), v: first.handles[handle].v + 10 * Math.cos(i) });
        const whole = milliseconds(() => figures.draw(wanted));
        const dragged = handle < 0 ? "-" : milliseconds((i) => figures.drawMoved({ ...wanted, held: first.view, put: put(i) })).toFixed(1);
        console.log(`${name.padEnd(22)} ${dragged.padStart(8)} ${whole.toFixed(1).padStart(7)}`);
    }
}
