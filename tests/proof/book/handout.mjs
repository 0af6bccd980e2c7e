// handout.mjs - the site for a class whose solutions stay private: its verdicts are those of the handout in a terminal,
// word for word, and no file of it has anything of a solution. Blanks and right answers need no whole compiler.
//
//   node handout.mjs SITE HANDOUT WASM    HANDOUT: unpacked, after 'make all' in it; WASM: what the site is linked from;
//                                         STEMS: of which chapters; COUNT: wrong answers of each
import {execFileSync, spawnSync} from 'node:child_process';
import {existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {gunzipSync} from 'node:zlib';
import {load, unpack} from '../../../chapters/book/compiler.js';
import {createJudge} from '../../../chapters/book/judge.js';
import {WholeCompilerNeeded, toolsOf} from '../../../chapters/book/tools.js';

const [site, handout, wasm] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'handout-'));
process.on('exit', () => rmSync(folder, {recursive: true}));
let passed = 0, failed = 0;
function check(isGood, what) {
  if (isGood) { passed++; return; }
  failed++;
  console.log(`not ok: ${what}`);
}
const filesIn = root => readdirSync(root, {recursive: true}).map(name => join(root, name)).filter(path => statSync(path).isFile());
const opened = path => path.endsWith('.gz') ? gunzipSync(readFileSync(path))
  : path.endsWith('.xz') ? execFileSync('xz', ['-dc', path], {maxBuffer: 1 << 28}) : readFileSync(path);

// ---- nothing of a solution ---------------------------------------------------------------------------

const solutions = readdirSync('solutions').filter(name => /^\d\d-.*\.c$/.test(name));
const exercises = new Set(readFileSync('build/exercises.names', 'utf8').trim().split('\n'));

// Names of helpers and lines of comments, if the handout has them nowhere.
const published = filesIn(handout).filter(path => !path.includes('/build/') && /\.(c|h|md|hints|gp|def|mk|table)$/.test(path)).map(path => readFileSync(path, 'utf8')).join('\n');
const secrets = solutions.flatMap(name => {
  const text = readFileSync(join('solutions', name), 'utf8');
  const helpers = [...text.matchAll(/^static [^;=()]*?\b(\w+_\w+)\(/gm)].map(([, helper]) => helper);
  const comments = [...text.matchAll(/\/\/ (.{20,})$/gm)].map(([, words]) => words);
  return [...helpers, ...comments].filter(each => !published.includes(each));
});
check(secrets.length > 10, `only ${secrets.length} helpers and comments of solutions are looked for`);
for (const path of filesIn(site)) {
  const bytes = opened(path);
  for (const secret of secrets)
    check(!bytes.includes(secret), `${path} has '${secret}' of a solution`);
}

// An object that is linked with answers defines no exercise, under any name.
for (const name of ['pictures.pack.gz', 'compiler/pack.xz'])
  for (const [path, bytes] of unpack(opened(join(site, name)))) {
    check(!/right|reference|solution/.test(path), `${name} has ${path}`);
    if (!/^link\/.*\.[oa]$|common\.a$/.test(path)) continue;
    const object = join(folder, path.replaceAll('/', '-'));
    writeFileSync(object, bytes);
    for (const defined of execFileSync('llvm-nm', ['--defined-only', '--format=just-symbols', object], {encoding: 'utf8'}).split('\n'))
      check(!exercises.has(defined.replace(/^(lent|answer|reference|right)_/, '')), `${name}, ${path} defines ${defined}`);
  }
check(!readdirSync(join(site, 'programs')).some(name => /^\d\d-/.test(name)), "a chapter's program is in the site");

// Programs have no names; but they are linked from objects, and each says of which files it was made.
const made = filesIn(wasm).filter(path => path.endsWith('.d') && !path.includes('/ray-casting/'));
check(made.length > 50, `only ${made.length} objects say of which files they were made`);
for (const path of made)
  check(!/\b(solutions\/|tests\/\d\d-|tests\/judge\/reference\/(?!rename))/.test(readFileSync(path, 'utf8')), `${path}: a solution, or a test`);

// ---- the same verdicts ---------------------------------------------------------------------------------

const compiler = await load({fetchBytes: async name => new Uint8Array(readFileSync(join(site, name)))});
const pictures = unpack(opened(join(site, 'pictures.pack.gz'))), tools = toolsOf(compiler, pictures);
const texts = JSON.parse(readFileSync(join(site, 'tree/files.json'), 'utf8'));
const program = name => new WebAssembly.Module(readFileSync(join(site, `programs/${name}.wasm`)));
const modules = {course: program('course'), judge: program('judge')};
const tables = readdirSync(join(site, 'tables')).map(name => [`tables/${name.slice(0, -3)}`, opened(join(site, 'tables', name))]);
const files = new Map([...Object.entries(texts), ...Object.entries(JSON.parse(readFileSync(join(site, 'figures/files.json'), 'utf8'))),
  ...[...pictures].filter(([path]) => /\.(png|nff)$/.test(path)), ...tables]);

let isWhole = false;
async function inPage(stem, sources, what) {
  try {
    const judge = createJudge({modules, files, compile: tools.compile, link: tools.linkAnswer});
    const verdict = await judge.draw({stem, sources}, async (words, all) => tools.link(words, all));
    return verdict.text;
  } catch (error) {
    if (!(error instanceof WholeCompilerNeeded) || isWhole) throw error;
    check(!/^(all blank|right)/.test(what), `${stem}, ${what}: the whole compiler is needed`);
    isWhole = true;
    await tools.takeWhole();
    return inPage(stem, sources, what);
  }
}
function inTerminal(stem, sources) {
  for (const name of ['figures', 'so-far', 'gallery', 'verdict'])
    for (const path of existsSync(join(handout, 'build/exercises', name)) ? filesIn(join(handout, 'build/exercises', name)) : [])
      if (!path.endsWith('/plan')) rmSync(path);
  for (const [name, text] of Object.entries({...blanks, ...sources})) writeFileSync(join(handout, `exercises/${name}.c`), text);
  const ran = spawnSync('build/course', ['exercises', 'build/exercises/verdict/plan', stem], {cwd: handout, encoding: 'utf8', env: {PATH: process.env.PATH, COLUMNS: ''}});
  return ran.stdout;
}
const stems = solutions.map(name => name.slice(0, -2));
const blanks = Object.fromEntries(stems.map(stem => [stem, readFileSync(`build/blanks/${stem}.c`, 'utf8')]));
const right = Object.fromEntries(stems.map(stem => [stem, readFileSync(`solutions/${stem}.c`, 'utf8')]));

/** COUNT wrong answers: in each, another operator of the right answer is the opposite one. */
function wrong(text, count) {
  const opposite = {' + ': ' - ', ' - ': ' + ', ' * ': ' / ', ' / ': ' * ', ' < ': ' > ', ' > ': ' < '};
  const places = [...text.matchAll(/^ .*?( [-+*/<>] )/gm)].filter(([line]) => !line.includes('//')).map(each => [each.index + each[0].length - 3, each[1]]);
  const step = Math.max(1, places.length / count);
  return Array.from({length: Math.min(count, places.length)}, (_, i) => places[Math.floor(i * step)])
    .map(([at, operator]) => text.slice(0, at) + opposite[operator] + text.slice(at + 3));
}
// The compilers' own words differ.
const told = text => text.replace(/ error: .*/, ' error');
async function compare(stem, what, sources) {
  const ours = told(inTerminal(stem, sources)), theirs = told(await inPage(stem, {...blanks, ...sources}, what));
  check(ours === theirs && ours.length > 50, `${stem}, ${what}`);
  if (ours === theirs) return;
  for (const [name, text] of [['terminal', ours], ['page', theirs]]) writeFileSync(join(folder, name), text);
  console.log(spawnSync('diff', ['-u', join(folder, 'terminal'), join(folder, 'page')], {encoding: 'utf8'}).stdout);
}
const before = stem => Object.fromEntries(Object.entries(right).filter(([other]) => other < stem));
for (const stem of (process.env.STEMS ?? '02-cameras 05-quadratic 06-ray-casting').split(' ')) {
  await compare(stem, 'all blank', {});
  await compare(stem, 'right', {...before(stem), [stem]: right[stem]});
  await compare(stem, 'right, on blanks', {[stem]: right[stem]});
  await compare(stem, 'right, on what does not compile', {...before(stem), '01-corners': 'not C\n', [stem]: right[stem]});
  await compare(stem, 'does not compile', {...before(stem), [stem]: right[stem].replace(/;\n}/, '\n}')});
  await compare(stem, 'helpers of one name', {...before(stem), '01-corners': `${right['01-corners']}\nint helper(void);\nint helper(void) { return 1; }\n`,
    [stem]: `${right[stem]}\nint helper(void);\nint helper(void) { return 2; }\n`});
  for (const [i, text] of wrong(right[stem], Number(process.env.COUNT) || 10).entries())
    await compare(stem, `wrong answer ${i}`, {...before(stem), [stem]: text});
}
console.log(`the site of a handout: ${passed} passed, ${failed} failed`);
process.exitCode = failed > 0 ? 1 : 0;
