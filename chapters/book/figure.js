// figure.js - draws a figure in a page, as 'make figures' does: the chapter's program writes the script, gnuplot
// draws it, and finish_figure.js makes of that the figure that is shown.
//
// Nothing is computed here: the program says what is drawn, what can be dragged and where it is on the canvas
// (common/figure/handles.c), and which options a drag gives.
import {finishFigure} from './finish_figure.js';
import {loadGnuplot} from './gnuplot.js';
import {run} from './wasi.js';

/** The canvas: what its height is in its units, and its width by shape (common/figure/plot.gp). */
export const CANVAS = {height: 540, width: {'16:9': 960, '4:3': 720}};

/**
 * @typedef {{name: string, words: string, u: number, v: number, options: Object<string, string>}} Handle
 *   a thing to drag: its place on the canvas, from the lower left, if it is there; the values of the options that
 *   move it
 * @typedef {{program: WebAssembly.Module, stem: string, name: string, options?: Object<string, string>,
 *   arguments?: string[], theme?: string, shape?: string, step?: number, held?: string}} Wanted
 *   held: the view of a drawing, which is kept while a handle of it is dragged
 * @typedef {{svg: string, title: string, words: string, steps: number, handles: Handle[],
 *   typed: {words: string, options: Object<string, string>}[], view: string}} Drawn
 *   typed: numbers that cannot be dragged
 */

export class FigureError extends Error {}

const text = new TextDecoder();
const as_text = bytes => bytes === undefined ? '' : text.decode(bytes);

/**
 * @param {{gnuplot: WebAssembly.Module, files: Object<string, string|Uint8Array>}} given
 *   files: the toolkit's files that programs read, by their path from the top: layouts, scenes
 */
export async function loadFigures({gnuplot: module, files}) {
  const gnuplot = await loadGnuplot(module);

  /** What a program's figure says: on stdout, and in files. */
  function ask(wanted, more) {
    const {program, stem, name, options = {}} = wanted;
    const args = [stem, ...Object.entries(options).map(([key, value]) => `--${key}=${value}`), '--figure', name,
      '--shape', wanted.shape ?? '16:9', ...(wanted.held ? ['--held', wanted.held] : []), ...more, ...(wanted.arguments ?? [])];
    const result = run(program, {args, files});
    if (result.status !== 0) throw new FigureError(result.stderr.trim() || result.trap);
    return result;
  }

  /** A figure's script, drawn; pictures: the file of that name which its program wrote. */
  function drawScript(script, {theme = 'light', shape = '16:9', step = 1000} = {}, pictures = '') {
    const settings = `format='svg'; theme='${theme}'; shape='${shape}'; step=${step}; output='figure'; framed=1`;
    const end = "set print 'words'; @say; set print 'steps'; print steps; unset print";
    const drawn = gnuplot.run(['-d', '-e', settings, 'script.gp', '-e', end], {'script.gp': script},
      ['figure.svg', 'words', 'steps']);
    if (drawn.status !== 0 || drawn.files['figure.svg'] === undefined) throw new FigureError(`gnuplot: ${drawn.said}`);
    const {'figure.svg': svg, words: said, steps} = drawn.files;
    const [title, , words] = said.split('\n');
    return {svg: finishFigure(svg, said, pictures), title, words, steps: Number(steps)};
  }

  return {
    drawScript,

    /** @param {Wanted} wanted @returns {Drawn} */
    draw(wanted) {
      const told = ask(wanted, ['--live', '.']);
      const live = JSON.parse(as_text(told.files.get('handles.json')) || '{"handles": []}');
      return {...drawScript(told.stdout, wanted, as_text(told.files.get('pictures'))), ...live, name: wanted.name};
    },

    /**
     * The options that put a handle there, or as near as they may.
     * @param {Wanted} wanted with the view that the handle was drawn in
     * @returns {Object<string, string>}
     */
    drag(wanted, handle, u, v) {
      return JSON.parse(ask(wanted, ['--drag', `${handle},${u},${v}`]).stdout);
    },

    /**
     * The figure after a handle is put somewhere else, and its options.
     * @param {Wanted & {put?: {handle: number, u: number, v: number} | {handle: number, by: object}}} wanted
     *        put: by a drag, to a place; or by a key (nudge)
     * @returns {Drawn & {options: Object<string, string>}}
     */
    drawMoved({put, ...wanted}) {
      const moved = !put ? {} : put.by ? this.nudge(wanted, put.handle, put.by) : this.drag(wanted, put.handle, put.u, put.v);
      const options = {...wanted.options, ...moved};
      return {...this.draw({...wanted, options}), options};
    },

    /**
     * The options after a key: the handle moves by this much, or as much farther as it must to move at all.
     * @param {Wanted} wanted
     * @param {{u: number, v: number, du: number, dv: number}} by from its place, and how far on the canvas
     */
    nudge(wanted, handle, {u, v, du, dv}) {
      let options = this.drag(wanted, handle, u, v);
      const before = JSON.stringify(options);
      for (let times = 1; times < 64 && JSON.stringify(options) === before; times *= 2)
        options = this.drag(wanted, handle, u + times * du, v + times * dv);
      return options;
    },
  };
}
