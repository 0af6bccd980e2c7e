// verdicts.mjs - the page's verdict on each known answer is the terminal's, word for word, and so are the
// pictures that it draws, pixel for pixel.
//
//   node verdicts.mjs BUILD WASM BOOK STEM...    COUNT: only so many of each chapter; SEED: which; JOBS: processes
//
// An answer is compiled by the compiler of the terminal, and by clang for the page; then both run
// tests/course/course.c, one as a process and one as an instance. First come answers that crash, hang, print and so
// on, compiled as a student's are. The programs of the known answers are linked once: each is a number in them.
import {execFileSync, fork, spawnSync} from 'node:child_process';
import {existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, symlinkSync, writeFileSync} from 'node:fs';
import {cpus, tmpdir} from 'node:os';
import {join} from 'node:path';
import {inflateSync} from 'node:zlib';
import {createJudge} from '../../../chapters/book/judge.js';

const [build, wasm, book, ...stems] = process.argv.slice(2);
const count = Number(process.env.COUNT) || Infinity, top = process.cwd();
const folder = mkdtempSync(join(tmpdir(), 'verdicts-')), terminal = join(folder, 'tree'), scratch = join(folder, 'scratch'), kept = join(folder, 'kept');
process.on('exit', () => rmSync(folder, {recursive: true}));
for (const at of [scratch, kept]) mkdirSync(at);

// ---- the terminal: a tree of links, with exercises/ and build/exercises/ of its own ---------------

function plant() {
  for (const at of ['exercises', 'build/exercises/verdict']) mkdirSync(join(terminal, at), {recursive: true});
  const link = (names, from) => names.forEach(name => existsSync(join(terminal, from, name)) ||
    symlinkSync(join(top, from, name), join(terminal, from, name)));
  link(readdirSync(top).filter(name => name[0] !== '.'), '.');
  link(readdirSync(join(top, 'build')), 'build');
  link(readdirSync(join(top, 'exercises')).filter(name => !name.endsWith('.c')), 'exercises');
}
const wholePlan = () => readFileSync(`${build}/exercises/verdict/plan`, 'utf8');
/** A known answer is two objects: its number, and all answers. */
function plan(stem) {
  const lines = wholePlan().split('\n').filter(line => !line.startsWith('hide\t'));
  const object = join(top, build, 'known', `${stem}.o`);
  const at = lines.indexOf(`chapter\t${stem}`);
  const libraries = ['known/exercise.a', 'common.a'].map(name => join(top, build, name)).join(' '), add = (key, from, objects) => {
    const i = lines.findIndex((line, i) => i >= from && line.startsWith(`${key}\t`));
    lines[i] = `${key}\t${objects} ${lines[i].slice(key.length + 1)}`;
  };
  add('objects', at, object);
  add('libraries', 0, `${object} ${libraries}`); // of pictures
  const compile = lines.findIndex(line => line.startsWith('compile\t'));
  const cc = process.env.CC || 'cc', once = `sh tests/proof/book/once.sh ${kept}`;
  lines[compile] = `compile\t${once} ${cc} -c`;
  return lines.join('\n').replace('\nlink\t', `$&${once} `);
}
/** Of pictures that were shown: they are shown again if their function was wrong meanwhile. */
let marks = [];
const sameTanf = join(top, build, 'known', 'tanf.so');
function inTerminal(stem, how, number) {
  for (const name of ['figures', 'so-far', 'gallery', 'verdict']) rmSync(join(terminal, 'build/exercises', name), {recursive: true, force: true});
  mkdirSync(join(terminal, 'build/exercises/verdict'));
  writeFileSync(join(terminal, 'build/exercises/verdict/plan'), how);
  for (const mark of marks) writeFileSync(join(terminal, mark), '');
  const ran = spawnSync(join(top, build, 'course'), ['exercises', 'build/exercises/verdict/plan', stem],
    {cwd: terminal, encoding: 'utf8', env: {PATH: process.env.PATH, COLUMNS: '', LD_PRELOAD: sameTanf, KNOWN_ANSWER: known(number)}});
  const pictures = {};
  for (const at of ['figures', 'so-far', 'gallery']) {
    const of = join(terminal, 'build/exercises', at);
    if (existsSync(of)) for (const name of readdirSync(of)) if (/\.(png|gp)$/.test(name)) pictures[name] = readFileSync(join(of, name));
  }
  const verdict = 'build/exercises/verdict/';
  const marksNow = readdirSync(join(terminal, verdict)).filter(name => name.endsWith('.drawn')).map(name => verdict + name);
  return {text: ran.stdout, errors: ran.stderr, pictures, marks: marksNow};
}

// ---- the page ------------------------------------------------------------------------------------

const load = name => new WebAssembly.Module(readFileSync(`${book}/programs/${name}.wasm`));
const modules = {course: load('course'), judge: load('judge')};
const tree = new Map([['plan', readFileSync(`${book}/tree/plan`)], ['link/spheres.png', readFileSync(`${wasm}/link/spheres.png`)]]);
for (const path of execFileSync('git', ['ls-files', 'common', 'exercises', 'chapters', 'tests/judge/layouts', 'tests/course/pictures'], {encoding: 'utf8'}).split('\n'))
  if (/\.(gp|nff|h|hints)$/.test(path)) tree.set(path, readFileSync(path));
for (const stem of stems) tree.set(`tables/${stem}.table`, readFileSync(`${build}/tables/${stem}.table`));
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
/** A program is linked once for all known answers; which of them it has is a text in it. */
const known = number => `known answer ${String(number).padStart(6, '0')}`, ANY = known(0);
const linkedOnce = new Map();
function numbered(bytes, number) {
  const copy = Buffer.from(bytes), at = copy.indexOf(ANY);
  if (at < 0 || copy.indexOf(ANY, at + 1) >= 0) throw new Error('a program has the number of its answer not once');
  copy.write(known(number), at);
  return copy;
}
function link(words, files, number) {
  const output = words[words.indexOf('-o') + 1], stem = /([0-9]+-[a-z-]+)\//.exec(output)[1], isAnswer = /\/(answering|alone)$/.test(output);
  const before = linkedOnce.get(words.join(' ')), linked = join(scratch, 'linked.wasm');
  if (before && !asStudents) return {...before.result, module: new WebAssembly.Module(numbered(before.bytes, number))};
  const objects = words.filter(word => /\.[oa]$/.test(word)).map(word => {
    if (!files.get(word)) return archives[word] ?? join(wasm, word);
    const at = join(scratch, word.replaceAll('/', '-'));
    writeFileSync(at, files.get(word));
    return at;
  });
  const names = readFileSync(`${wasm}/names/${stem}`, 'utf8').trim().split('\n');
  const result = clang([...isAnswer ? ['-mexec-model=reactor', '-Wl,--export=__stack_pointer', ...names.map(name => `-Wl,--wrap=${name}`)] : [],
    '-Wl,--stack-first', '-Wl,-z,stack-size=1048576', '-Wl,--gc-sections', '-Wl,--strip-all', '-Wl,--no-check-features', '-o', linked,
    ...objects, ...asStudents ? [] : [`${wasm}/known/${stem}.o`, `${wasm}/known/exercise.a`], `${wasm}/common.a`, ...['signal', 'mman', 'process-clocks', 'getpid'].map(e => `-lwasi-emulated-${e}`), '-lm']);
  if (result.status !== 0) return result;
  const bytes = readFileSync(linked);
  if (asStudents) return {...result, module: new WebAssembly.Module(bytes)};
  linkedOnce.set(words.join(' '), {result, bytes});
  return {...result, module: new WebAssembly.Module(numbered(bytes, number))};
}
function inPage(stem, source, number) {
  const judge = createJudge({modules, files: new Map([...tree, ...marks.map(mark => [mark, ''])]), compile, link: (words, files) => link(words, files, number)});
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

let passed = 0, failed = 0, drawn = 0;
function fail(stem, number, what, ours, theirs) {
  failed++;
  console.log(`not ok: ${stem} ${number}: ${what}`);
  if (ours === undefined) return;
  for (const [name, text] of [['terminal', ours], ['page', theirs]]) writeFileSync(join(folder, name), text);
  console.log(spawnSync('diff', ['-u', join(folder, 'terminal'), join(folder, 'page')], {encoding: 'utf8'}).stdout);
}
function compareKnown(stem, number, what) {
  compare(stem, number, what, `const char known_answer[] = "${ANY}";\n`, plan(stem));
}
function compare(stem, number, what, source, how) {
  for (const other of stems) rmSync(join(terminal, 'exercises', `${other}.c`), {force: true}); // the page has this answer alone
  writeFileSync(join(terminal, 'exercises', `${stem}.c`), source);
  const ours = inTerminal(stem, how, number), theirs = inPage(stem, source, number);
  marks = ours.marks;
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
  'sums without a beginning': 'double x, y, z; x += c.origin[0]; y += c.origin[1]; z += c.origin[2]; return vec3_of(x, y, z);',
  'a colour that does not begin at black': 'vec3 sum; for (int i = 0; i < 3; i++) sum += c.origin; return sum;',
  'a helper that sums up without a beginning': 'return total(c);',
  'the same where another helper has left zeros': 'vec3 sum = black(c); for (int i = 0; i < 1; i++) sum += total(c); return sum;',
  'an int that was never set': 'int i; return i == 0 ? c.origin : i * c.right;',
  'a bool that was never set': 'bool far; if (c.distance > 1) far = true; return far ? c.right : c.up;',
  'a loop up to v[3]': 'double sum = 0; for (int i = 0; i <= 3; i++) sum += c.up[i]; return sum * c.right;',
  'printed words': 'printf("hello %g\\n", c.width); return c.origin;',
  'too many printed words': 'for (;;) { printf("hello %g\\n", c.width); }',
  'another answer that is not answered': 'return image_plane_vector(c, 0, 1);',
};
function compareEndings(stem) {
  const helper = (name, sum) => `static vec3 ${name}(Camera c)\n{\n    ${sum}\n    return sum;\n}\n`;
  const helpers = helper('black', 'vec3 sum = {0, 0, 0}; for (int i = 0; i < 3; i++) sum[i] *= c.origin[i];') +
    helper('total', 'vec3 sum; for (int i = 0; i < 3; i++) sum[i] += c.origin[i];');
  const blank = readFileSync(`build/blanks/${stem}.c`, 'utf8').replace('vec3 upper_left(', `${helpers}$&`);
  asStudents = true;
  const how = wholePlan().replace(/^compile\t\S+/m, '$& -w');
  for (const [what, body] of Object.entries(bodies))
    compare(stem, 'by hand', what, blank.replace('#include', '#include <stdio.h>\n#include <stdlib.h>\n#include')
      .replace(/(vec3 upper_left\(Camera c\)\n\{\n)[^}]*/, (_, start) => `${start}    ${body}\n`), how);
  asStudents = false;
}

/** Of all answers, those that this process compares. */
function compareAll(part, parts) {
  plant();
  if (part === 0 && stems.includes('01-corners')) compareEndings('01-corners');
  for (const stem of stems) {
    const answers = execFileSync(`${build}/tests/proof/book/list_known`, [stem], {encoding: 'utf8'}).trim().split('\n');
    const step = Math.max(1, Math.floor(answers.length / count)), began = Date.now();
    marks = [];
    for (let i = (Number(process.env.SEED) || 0) % step, k = 0; i < answers.length; i += step, k++) {
      if (k % parts !== part) continue;
      compareKnown(stem, i, answers[i]);
      if (process.stderr.isTTY && part === 0) process.stderr.write(`\r  ${stem} ${i + 1} of ${answers.length} `);
    }
    if (part === 0) console.log(`${stem}: ${((Date.now() - began) / 1000).toFixed(0)} s`);
  }
}
function finish() {
  console.log(`verdicts in the page: ${passed} passed, ${failed} failed, ${drawn} figures and pictures`);
  process.exitCode = failed > 0 ? 1 : 0;
}
const jobs = Number(process.env.JOBS) || cpus().length, part = process.env.PART;
if (part !== undefined) {
  compareAll(Number(part), jobs);
  process.send({passed, failed, drawn});
} else if (jobs === 1) {
  compareAll(0, 1);
  finish();
} else {
  let running = jobs;
  for (let i = 0; i < jobs; i++) {
    let said;
    fork(process.argv[1], process.argv.slice(2), {env: {...process.env, PART: i, JOBS: jobs}}).on('message', result => { said = result; }).on('exit', () => {
      passed += said?.passed ?? 0;
      failed += said?.failed ?? 1;
      drawn += said?.drawn ?? 0;
      if (--running === 0) finish();
    });
  }
}
