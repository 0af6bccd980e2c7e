// cut_compiler.mjs - writes a compiler of the page: whole, or cut to the functions of a list.
// Usage: node cut_compiler.mjs CLANG.wasm OUT.wasm [KEPT.txt]
import {createHash} from 'node:crypto';
import {readFileSync, writeFileSync} from 'node:fs';
import {cut} from './cut.js';
import {keptList} from './kept.js';

const [clang, out, kept] = process.argv.slice(2);
const bytes = new Uint8Array(readFileSync(clang)), list = kept && keptList(readFileSync(kept, 'utf8'));
if (list && list.hash !== createHash('sha256').update(bytes).digest('hex')) {
  console.error(`${clang} is another compiler than the one of ${kept}: 'make book-train' makes that list again`);
  process.exit(1);
}
writeFileSync(out, cut(bytes, list ? list.isKept : () => true));
