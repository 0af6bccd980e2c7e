// gnuplot.js - gnuplot, as WebAssembly: it draws a figure's script as SVG.
//
// gnuplot leaves its memory and its stack as they are when it ends, so after each drawing both are put back to what
// they were before the first.
import {PAGE, clear, isEmpty} from './clear_memory.js';
import createGnuplot from 'gnuplot-wasm/src/gnuplot.js';

/**
 * @param {WebAssembly.Module} module gnuplot-wasm/src/gnuplot.wasm
 * @returns {Promise<{run(args: string[], files: Object<string, string>, wanted: string[]):
 *           {status: number, said: string, files: Object<string, string>}}>}
 */
export async function loadGnuplot(module) {
  let said = [], made;
  const hear = line => said.push(line);
  const gnuplot = await createGnuplot({
    noInitialRun: true, noFSInit: true, print: hear, printErr: hear,
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(module, imports).then(instance => {
        made = instance.exports;
        done(instance, module);
      });
      return {};
    },
  });
  gnuplot.FS.init(() => null, null, null);
  const {buffer} = gnuplot.HEAPU8, pages = buffer.byteLength / PAGE;
  let used = pages;
  while (used > 0 && isEmpty(buffer, used - 1)) used--;
  const fresh = gnuplot.HEAPU8.slice(0, used * PAGE), stack = made.emscripten_stack_get_current();

  function forget(name) {
    if (gnuplot.FS.analyzePath(name).exists) gnuplot.FS.unlink(name);
  }

  return {
    run(args, files, wanted) {
      said = [];
      for (const [name, contents] of Object.entries(files)) gnuplot.FS.writeFile(name, contents);
      const status = gnuplot.callMain([...args]);
      made._emscripten_stack_restore(stack);
      gnuplot.HEAPU8.set(fresh);
      clear(buffer, used, pages);
      const drawn = {};
      for (const name of wanted)
        if (gnuplot.FS.analyzePath(name).exists) drawn[name] = gnuplot.FS.readFile(name, {encoding: 'utf8'});
      for (const name of [...Object.keys(files), ...wanted]) forget(name);
      return {status, said: said.join('\n'), files: drawn};
    },
  };
}
