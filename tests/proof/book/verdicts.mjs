// verdicts.mjs - the page's verdict on each known answer is the terminal's, word for word, and so are the
// pictures that it draws, pixel for pixel.
//
//   node verdicts.mjs BUILD WASM BOOK STEM...    COUNT: only so many of each chapter; SEED: which
//
// An answer is compiled by the compiler of the terminal, and by clang for the page; then both run
// tests/course/course.c, one as a process and one as an instance. First come answers that crash, hang, print and so
// on, compiled as a student's are.
import {execFileSync, spawnSync} from 'node:child_process';
import {cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, symlinkSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {inflateSync} from 'node:zlib';
import {createJudge} from '../../../chapters/book/judge.js';

const [build, wasm, book, ...stems] = process.argv.slice(2);
const count = Number(process.env.COUNT) || Infinity, top = process.cwd();
const folder = mkdtempSync(join(tmpdir(), 'verdicts-')), terminal = join(folder, 'tree'), scratch = join(folder, 'scratch');
process.on('exit', () => rmSync(folder, {recursive: true}));
mkdirSync(scratch);

// ---- the terminal: a tree of links, with exercises/ and build/exercises/ of its own ---------------

function plant() {
  for (const at of ['exercises', 'build/exercises/verdict']) mkdirSync(join(terminal, at), {recursive: true});
  const link = (names, from) => names.forEach(name => existsSync(join(terminal, from, name)) ||
    symlinkSync(join(top, from, name), join(terminal, from, name)));
  link(readdirSync(top).filter(name => name[0] !== '.'), '.');
  link(readdirSync(join(top, 'build')), 'build');
  link(readdirSync(join(top, 'exercises')).filter(name => !name.endsWith('.c')), 'exercises');
}
const wholePlan = () => readFileSync(`${build}/exercises/verdict/plan`, 'utf8').replace(/^compile early\t.*\n/m, '');
/** A known answer is two objects: its number, and all answers. */
function plan(stem) {
  const lines = wholePlan().split('\n').filter(line => !/^(shared|loading|lend shared|lent|hide)\t/.test(line));
  const known = join(top, build, 'known', `${stem}.o`);
  const at = lines.indexOf(`chapter\t${stem}`);
  const add = (key, from) => { const i = lines.findIndex((line, i) => i >= from && line.startsWith(key + '\t')); lines[i] = `${key}\t${known} ${lines[i].slice(key.length + 1)}`; };
  add('objects', at);
  add('libraries', 0);
  const compile = lines.findIndex(line => line.startsWith('compile\t'));
  lines[compile] = `compile\t${process.env.CC || 'cc'} -c`;
  return lines.join('\n');
}
const sameTanf = join(top, build, 'known', 'tanf.so');
function inTerminal(stem, how = plan(stem)) {
  for (const name of ['figures', 'so-far', 'gallery', 'verdict']) rmSync(join(terminal, 'build/exercises', name), {recursive: true, force: true});
  mkdirSync(join(terminal, 'build/exercises/verdict'));
  writeFileSync(join(terminal, 'build/exercises/verdict/plan'), how);
  const ran = spawnSync(join(top, build, 'course'), ['exercises', 'build/exercises/verdict/plan', stem],
    {cwd: terminal, encoding: 'utf8', env: {PATH: process.env.PATH, COLUMNS: '', LD_PRELOAD: sameTanf}});
  const pictures = {};
  for (const at of ['figures', 'so-far', 'gallery']) {
    const of = join(terminal, 'build/exercises', at);
    if (existsSync(of)) for (const name of readdirSync(of)) if (/\.(png|gp)$/.test(name)) pictures[name] = readFileSync(join(of, name));
  }
  return {text: ran.stdout, errors: ran.stderr, pictures};
}

// ---- the page ------------------------------------------------------------------------------------

const load = name => new WebAssembly.Module(readFileSync(`${book}/programs/${name}.wasm`));
const modules = {course: load('course'), judge: load('judge')};
const tree = new Map([['plan', readFileSync(`${book}/tree/plan`)], ['link/spheres.png', readFileSync(`${wasm}/link/spheres.png`)]]);
for (const path of execFileSync('git', ['ls-files', 'common', 'exercises', 'chapters', 'tests/judge/layouts', 'tests/course/pictures'], {encoding: 'utf8'}).split('\n'))
  if (/\.(gp|nff|h|hints)$/.test(path)) tree.set(path, readFileSync(path));
for (const name of readdirSync('build/blanks').filter(name => name.endsWith('.c'))) tree.set(`build/blanks/${name}`, readFileSync(`build/blanks/${name}`));

const target = ['--target=wasm32-wasi', '-mmutable-globals'];
function clang(words) {
  const ran = spawnSync('clang', [...target, ...words], {encoding: 'utf8'});
  return {status: ran.status ?? 127, said: ran.stderr};
}
let asStudents = false;
const studentFlags = ['-std=c11', '-D_DEFAULT_SOURCE', '-ffp-contract=off', `-I${top}`, '-O0', '-w', '-include', 'build/weak.h', '-ffunction-sections',
  '-fsanitize=bounds,null', '-fno-sanitize-recover=null', '-fsanitize-trap=bounds', '-fsanitize-coverage=edge,no-prune,trace-pc'];
function compile(words, files) {
  const source = words.at(-1), object = join(scratch, 'answer.o');
  writeFileSync(join(scratch, 'answer.c'), files.text(source));
  const result = clang([...asStudents ? studentFlags : [], '-c', '-o', object, join(scratch, 'answer.c')]);
  if (result.status === 0) files.put(words[words.indexOf('-o') + 1], readFileSync(object));
  return result;
}
const archives = {'link/common.a': `${wasm}/common.a`, 'link/shared.a': `${wasm}/shared.a`};
function link(words, files) {
  const output = words[words.indexOf('-o') + 1], stem = /([0-9]+-[a-z-]+)\//.exec(output)[1], isAnswer = /\/(answering|alone)$/.test(output);
  const objects = words.filter(word => /\.[oa]$/.test(word)).map(word => {
    if (!files.get(word)) return archives[word] ?? join(wasm, word);
    const at = join(scratch, word.replaceAll('/', '-'));
    writeFileSync(at, files.get(word));
    return at;
  });
  const names = readFileSync(`${wasm}/names/${stem}`, 'utf8').trim().split('\n');
  const result = clang([...isAnswer ? ['-mexec-model=reactor', '-Wl,--export=__stack_pointer', ...names.map(name => `-Wl,--wrap=${name}`)] : [],
    '-Wl,--stack-first', '-Wl,-z,stack-size=1048576', '-Wl,--gc-sections', '-Wl,--strip-all', '-Wl,--no-check-features', '-o', join(scratch, 'linked.wasm'),
    ...objects, ...asStudents ? [] : [`${wasm}/known/${stem}.o`], `${wasm}/common.a`, ...['signal', 'mman', 'process-clocks', 'getpid'].map(e => `-lwasi-emulated-${e}`), '-lm']);
  return result.status === 0 ? {...result, module: new WebAssembly.Module(readFileSync(join(scratch, 'linked.wasm')))} : result;
}
function inPage(stem, source) {
  const judge = createJudge({modules, files: tree, compile, link});
  return judge.judge({stem, sources: {[stem]: source}});
}

// ---- pictures ------------------------------------------------------------------------------------

/** The pixels of a PNG file without interlacing, three bytes each. */
function pixels(png) {
  const width = png.readUInt32BE(16), height = png.readUInt32BE(20), bits = png[24], kind = png[25];
  let palette;
  const parts = [];
  for (let at = 8; at < png.length;) {
    const size = png.readUInt32BE(at), name = png.toString('latin1', at + 4, at + 8), bytes = png.subarray(at + 8, at + 8 + size);
    if (name === 'PLTE') palette = bytes;
    if (name === 'IDAT') parts.push(bytes);
    at += 12 + size;
  }
  const data = inflateSync(Buffer.concat(parts)), channels = kind === 3 ? 1 : 3, row = Math.ceil(width * channels * bits / 8);
  const rgb = Buffer.alloc(3 * width * height);
  for (let y = 0, before = Buffer.alloc(row); y < height; y++) {
    const filter = data[y * (row + 1)], line = data.subarray(y * (row + 1) + 1, (y + 1) * (row + 1));
    if (filter === 2) for (let i = 0; i < row; i++) line[i] += before[i];
    else if (filter !== 0) throw new Error(`a filter that the toolkit does not write: ${filter}`);
    before = line;
    for (let x = 0; x < width; x++) {
      if (kind !== 3) { line.copy(rgb, 3 * (y * width + x), 3 * x, 3 * x + 3); continue; }
      const index = line[x * bits >> 3] >> (8 - bits - (x * bits & 7)) & (1 << bits) - 1;
      palette.copy(rgb, 3 * (y * width + x), 3 * index, 3 * index + 3);
    }
  }
  return Buffer.concat([Buffer.from(`${width} ${height} `), rgb]);
}

// ---- all of them -----------------------------------------------------------------------------------

plant();
let passed = 0, failed = 0, drawn = 0;
function fail(stem, number, what, ours, theirs) {
  failed++;
  console.log(`not ok: ${stem} ${number}: ${what}`);
  if (ours === undefined) return;
  for (const [name, text] of [['terminal', ours], ['page', theirs]]) writeFileSync(join(folder, name), text);
  console.log(spawnSync('diff', ['-u', join(folder, 'terminal'), join(folder, 'page')], {encoding: 'utf8'}).stdout);
}
function compareKnown(stem, number, what) {
  compare(stem, number, what, `// The known answer '${what.replace('\t', "', ")}.\nconst int known_answer = ${number};\n`);
}
function compare(stem, number, what, source, how) {
  writeFileSync(join(terminal, 'exercises', `${stem}.c`), source);
  const ours = inTerminal(stem, how), theirs = inPage(stem, source);
  if (ours.text !== theirs.text) return fail(stem, number, what, ours.text, theirs.text);
  const drawings = {...theirs.pictures};
  for (const [name, script] of Object.entries(theirs.figures)) drawings[`${name}.gp`] = script;
  for (const [name, bytes] of Object.entries(ours.pictures)) {
    const theirsHere = drawings[name] ?? drawings[name.replace(/\.png$/, '')];
    drawn++;
    if (theirsHere === undefined) return fail(stem, number, `${what}: the page has no ${name}`);
    const same = name.endsWith('.gp') ? theirsHere === bytes.toString() : pixels(bytes).equals(pixels(Buffer.from(theirsHere)));
    if (!same) return fail(stem, number, `${what}: ${name} differs`, ...name.endsWith('.gp') ? [bytes, theirsHere] : []);
  }
  passed++;
}

// An answer to the first exercise of chapter 01 that ends, or does not, in every way.
const bodies = {
  'an endless loop': 'for (volatile int i = 0;;) i++;',
  'no end of calls': 'static int depth; vec3 below = depth++ < 0 ? c.origin : upper_left(c); return below + c.up;',
  'a read of address 0': 'vec3 *volatile none = 0; return *none;',
  'a write to address 0': 'vec3 *volatile none = 0; *none = c.origin; return c.origin;',
  'the end of an array': 'double a[3] = {0}; for (int i = 0; i <= 3; i++) a[i] = i; return vec3_of(a[0], a[1], a[2]);',
  'a division by zero': 'volatile int none = 0, one = 1; return c.origin * (one / none);',
  'exit': 'exit(3);',
  'abort': 'abort();',
  'an unset result': 'vec3 v; v[0] = 1; return v;',
  'printed words': 'printf("hello %g\\n", c.width); return c.origin;',
  'too many printed words': 'for (;;) { printf("hello %g\\n", c.width); }',
  'another answer that is not answered': 'return image_plane_vector(c, 0, 1);',
};
function compareEndings(stem) {
  const blank = readFileSync(`build/blanks/${stem}.c`, 'utf8');
  asStudents = true;
  for (const [what, body] of Object.entries(bodies))
    compare(stem, 'by hand', what, blank.replace('#include', '#include <stdio.h>\n#include <stdlib.h>\n#include')
      .replace(/(vec3 upper_left\(Camera c\)\n\{\n)[^}]*/, (_, start) => `${start}    ${body}\n`), wholePlan().replace(/^compile\t\S+/m, '$& -w'));
  asStudents = false;
}

if (stems.includes('01-corners')) compareEndings('01-corners');
for (const stem of stems) {
  const known = execFileSync(`${build}/tests/proof/book/list_known`, [stem], {encoding: 'utf8'}).trim().split('\n');
  const step = Math.max(1, Math.floor(known.length / count)), began = Date.now();
  for (let i = (Number(process.env.SEED) || 0) % step; i < known.length; i += step) {
    compareKnown(stem, i, known[i]);
    if (process.stderr.isTTY) process.stderr.write(`\r  ${stem} ${i + 1} of ${known.length} `);
  }
  console.log(`${stem}: ${((Date.now() - began) / 1000).toFixed(0)} s`);
}
console.log(`verdicts in the page: ${passed} passed, ${failed} failed, ${drawn} figures and pictures`);
process.exitCode = failed > 0 ? 1 : 0;
