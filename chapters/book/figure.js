// figure.js - draws a figure in a page, as 'make figures' does: the chapter's program writes the script, gnuplot
// draws it, and finishFigure makes of that the figure that is shown.
//
// Nothing is computed here: the program says what is drawn, what can be dragged and where it is on the canvas
// (common/figure/plot_handle.c), and which options a drag gives.
import createGnuplot from "gnuplot-wasm/src/gnuplot.js";
import { PAGE, clear, isEmpty, run } from "./wasi.js";

/**
 * @typedef {{name: string, words: string, u: number, v: number, options: Object<string, string>}} Handle
 *   a thing to drag: its place on the canvas, from the lower left, if it is there; the values of the options that
 *   move it
 * @typedef {{program: WebAssembly.Module, stem: string, name: string, options?: Object<string, string>,
 *   theme?: string, shape?: string, step?: number, held?: string}} Wanted
 *   held: the view of a drawing, which is kept while a handle of it is dragged
 * @typedef {{svg: string, title: string, words: string, steps: number, handles: Handle[],
 *   typed: {words: string, options: Object<string, string>}[], view: string}} Drawn
 *   typed: numbers that cannot be dragged
 */

const text = new TextDecoder();
const as_text = (bytes) => bytes === undefined ? "" : text.decode(bytes);

/**
 * @param {{gnuplot: WebAssembly.Module, files: Object<string, string|Uint8Array>}} given
 *   files: the toolkit's files that programs read, by their path from the top: layouts, scenes
 */
export async function loadFigures({ gnuplot: module, files: texts }) {
    const files = new Map(Object.entries(texts).map(([path, contents]) => [path, typeof contents === "string" ? new TextEncoder().encode(contents) : contents]));
    const gnuplot = await loadGnuplot(module);

    /** What a program's figure says: on stdout, and in files. */
    function ask(wanted, more) {
        const { program, stem, name, options = {} } = wanted;
        const args = [stem, ...Object.entries(options).map(([key, value]) => `--${key}=${value}`), "--figure", name,
            "--shape", wanted.shape ?? "16:9", ...(wanted.held ? ["--held", wanted.held] : []), ...more];
        const result = run(program, { args, files });
        if (result.status !== 0)
            throw new Error(result.stderr.trim() || result.trap);
        return result;
    }

    /** A figure's script, drawn; pictures: the file of that name which its program wrote. */
    function drawScript(script, { theme = "light", shape = "16:9", step = 1000 } = {}, pictures = "") {
        const settings = `format='svg'; theme='${theme}'; shape='${shape}'; step=${step}; output='figure'; framed=1`;
        const end = "set print 'words'; @say; set print 'steps'; print steps; unset print";
        const drawn = gnuplot.run(["-d", "-e", settings, "script.gp", "-e", end], { "script.gp": script },
            ["figure.svg", "words", "steps"]);
        if (drawn.status !== 0 || drawn.files["figure.svg"] === undefined)
            throw new Error(`gnuplot: ${drawn.said}`);
        const { "figure.svg": svg, words: said, steps } = drawn.files;
        const [title, , words] = said.split("\n");
        return { svg: finishFigure(svg, said, pictures), title, words, steps: Number(steps) };
    }

    return {
        drawScript,

        /** @param {Wanted} wanted @returns {Drawn} */
        draw(wanted) {
            const told = ask(wanted, ["--live", "."]);
            const live = JSON.parse(as_text(told.files.get("handles.json")) || '{"handles": []}');
            return { ...drawScript(told.stdout, wanted, as_text(told.files.get("pictures"))), ...live, name: wanted.name };
        },

        /**
     * The options that put a handle there, or as near as they may.
     * @param {Wanted} wanted with the view that the handle was drawn in
     * @returns {Object<string, string>}
     */
        drag(wanted, handle, u, v) {
            return JSON.parse(ask(wanted, ["--drag", `${handle},${u},${v}`]).stdout);
        },

        /**
     * The figure after a handle is put somewhere else, and its options.
     * @param {Wanted & {put?: {handle: number, u: number, v: number, by?: object} | {handle: number, by: object, u?: number, v?: number}}} wanted
     *        put: by a drag, to a place; or by a key (nudge)
     * @returns {Drawn & {options: Object<string, string>}}
     */
        drawMoved({ put, ...wanted }) {
            const moved = !put ? {} : put.by ? this.nudge(wanted, put.handle, put.by) : this.drag(wanted, put.handle, put.u, put.v);
            const options = { ...wanted.options, ...moved };
            return { ...this.draw({ ...wanted, options }), options };
        },

        /**
     * The options after a key: the handle moves by this much, or as much farther as it must to move at all.
     * @param {Wanted} wanted
     * @param {number} handle
     * @param {{u: number, v: number, du: number, dv: number}} by from its place, and how far on the canvas
     */
        nudge(wanted, handle, { u, v, du, dv }) {
            let options = this.drag(wanted, handle, u, v);
            const before = JSON.stringify(options);
            for (let times = 1; times < 64 && JSON.stringify(options) === before; times *= 2)
                options = this.drag(wanted, handle, u + times * du, v + times * dv);
            return options;
        },
    };
}

// ---- the lesson's numbers -------------------------------------------------------------------------

const lectures = new WeakMap(); // the lecture's numbers, by the program that gives them

function namedNumbers(program, options) {
    const args = ["numbers", ...Object.entries(options).map(([key, value]) => `--${key}=${value}`)];
    const result = run(program, { args, files: {} });
    if (result.status !== 0)
        throw new Error(result.stderr.trim() || result.trap);
    return JSON.parse(result.stdout);
}

/**
 * The numbers of the lessons for another example than the lecture's (chapters/lessons/print_numbers.c).
 * @param {WebAssembly.Module} program numbers.wasm
 * @param {string} figure its name
 * @param {Object<string, string>} options of that figure
 * @returns {Object<string, string>} by its name, each number that is not the lecture's
 */
export function lessonNumbers(program, figure, options) {
    if (figure === "pixel-grid") // has a small screen of its own: it is not the example
        return {};
    if (!lectures.has(program))
        lectures.set(program, namedNumbers(program, {}));
    const lecture = lectures.get(program);
    return Object.fromEntries(Object.entries(namedNumbers(program, options)).filter(([name, text]) => text !== lecture[name]));
}

// ---- gnuplot --------------------------------------------------------------------------------------

// gnuplot leaves its memory and its stack as they are when it ends, so after each drawing both are put back to what
// they were before the first.

/**
 * @param {WebAssembly.Module} module gnuplot-wasm/src/gnuplot.wasm
 * @returns {Promise<{run(args: string[], files: Object<string, string>, wanted: string[]):
 *           {status: number, said: string, files: Object<string, string>}}>}
 */
export async function loadGnuplot(module) {
    let said = [];
    /** @type {any} */
    let made;
    const hear = (line) => said.push(line);
    const gnuplot = await createGnuplot({
        noInitialRun: true, noFSInit: true, print: hear, printErr: hear,
        instantiateWasm(imports, done) {
            WebAssembly.instantiate(module, imports).then((instance) => {
                made = instance.exports;
                done(instance, module);
            });
            return {};
        },
    });
    gnuplot.FS.init(() => null, null, null);
    const { buffer } = gnuplot.HEAPU8, pages = buffer.byteLength / PAGE;
    let used = pages;
    while (used > 0 && isEmpty(buffer, used - 1))
        used--;
    const fresh = gnuplot.HEAPU8.slice(0, used * PAGE), stack = made.emscripten_stack_get_current();

    function forget(name) {
        if (gnuplot.FS.analyzePath(name).exists)
            gnuplot.FS.unlink(name);
    }

    return {
        run(args, files, wanted) {
            said = [];
            for (const [name, contents] of Object.entries(files))
                gnuplot.FS.writeFile(name, contents);
            const status = gnuplot.callMain([...args]);
            made._emscripten_stack_restore(stack);
            gnuplot.HEAPU8.set(fresh);
            clear(buffer, used, pages, 64);
            /** @type {Object<string, string>} */
            const drawn = {};
            for (const name of wanted)
                if (gnuplot.FS.analyzePath(name).exists)
                    drawn[name] = gnuplot.FS.readFile(name, { encoding: "utf8" });
            for (const name of [...Object.keys(files), ...wanted])
                forget(name);
            return { status, said: said.join("\n"), files: drawn };
        },
    };
}

// ---- gnuplot's SVG --------------------------------------------------------------------------------

// The figure that a page shows, made of gnuplot's SVG as 'make figures' does (chapters/gallery/draw_figures.py), and with
// the pictures in it, which gnuplot cannot read in a page.

const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;");

/** The rectangle around a frame, from "d='M12.48,456.30 L473.28,456.30 ..."; undefined if there is none. */
function frameIn(line) {
    const corners = [.../d='M([^']*)/.exec(line)?.[1].matchAll(/([\d.-]+),([\d.-]+)/g) ?? []];
    const [[left, right], [top, bottom]] = [1, 2].map((i) => corners.map((corner) => Number(corner[i])))
        .map((numbers) => [Math.min(...numbers), Math.max(...numbers)]);
    return left < right && top < bottom ? { left, top, width: right - left, height: bottom - top } : undefined;
}

/** The PNG of a picture in base64, as the script has it: '$flat << EOD' and so on; undefined if it has not. */
function pictureIn(script, name) {
    const rows = script.split(`\n${name} << EOD\n`)[1]?.split("\nEOD")[0];
    return rows?.split("\n").filter((row) => !row.startsWith("#")).join("");
}

/**
 * @param {string} svg by gnuplot
 * @param {string} words the figure in words: its title, and its description
 * @param {string} script with the pictures for which gnuplot drew frames (common/figure/plot.gp)
 */
export function finishFigure(svg, words, script) {
    const [title, ...rest] = words.replace(/ +/g, " ").replace(/ \n/g, "\n").split("\n");
    let titled = false, described = false, picture;
    const lines = svg.replace(/\n$/, "").split("\n").map((line) => {
        if (!titled && line.includes("<title>")) {
            titled = true;
            return `<title id="title">${escaped(title)}</title>`;
        }
        if (!described && line.includes("<desc>")) {
            described = true;
            return `<desc id="description">${escaped(rest.join(" ").trim())}</desc>`;
        }
        const framed = /<title>picture ([^:]*): */.exec(line);
        if (framed) {
            picture = pictureIn(script, framed[1]);
            return line.replace(framed[0], "<title>");
        }
        const frame = picture && frameIn(line);
        if (frame) {
            const [x, y, width, height] = [frame.left, frame.top, frame.width, frame.height].map((n) => n.toFixed(2));
            const image = `<image x='${x}' y='${y}' width='${width}' height='${height}' preserveAspectRatio='none' ` +
        `xlink:href='data:image/png;base64,${picture}'/>`;
            picture = undefined;
            return image;
        }
        return line.replace(/^<svg/, '<svg role="img" aria-labelledby="title description" xml:space="preserve"')
            .replace(/(id=.gpPt.*?stroke-width=')[\d.]+/, (_, before) => `${before}0.6`);
    });
    return lines.join("\n").replace(/<g fill[^>]*>\n<\/g>\n/g, "").replaceAll('font-family="DejaVu Sans"', 'font-family="DejaVu Sans, Verdana, sans-serif"')
        .replaceAll('font-family="DejaVu Serif"', 'font-family="DejaVu Serif, Georgia, serif"') + "\n";
}
