// lesson_numbers.js - the numbers of a lesson for another example than the lecture's (instead/lesson_example.c).
import {run} from './wasi.js';

/**
 * @param {WebAssembly.Module} program NN-stem-numbers.wasm
 * @param {string} figure its name
 * @param {Object<string, string>} options of that figure
 * @returns {Object<string, string>} by its name, each number that is not the lecture's
 */
export function lessonNumbers(program, figure, options) {
  const args = ['numbers', `--figure=${figure}`, ...Object.entries(options).map(([key, value]) => `--${key}=${value}`)];
  const result = run(program, {args, files: {}});
  if (result.status !== 0) throw new Error(result.stderr.trim() || result.trap);
  return JSON.parse(result.stdout);
}
