// judge_worker.js - judges answers beside the page: the compiler and the judge. What a question needs is fetched when it
// is first asked.
import { load, unpack } from "./compiler.js";
import { createJudge, partsOf } from "./judge.js";
import { castLinker, toolsOf, WholeCompilerNeeded } from "./tools.js";
import { answerQuestions, fetched, once, program, tellProgress, texts, unzipped } from "./worker_questions.js";

// The compiler comes first, because there is most to do with it; the judge while the first answer is compiled.
let compilerIsHere;
const afterCompiler = new Promise((resolve) => { compilerIsHere = resolve; });
const compiler = once(() => load({ fetchBytes: fetched, progress: (done, all) => tellProgress("Fetching the compiler", done, all),
    onFetched() { tellProgress("Starting the compiler"); compilerIsHere(); } }));
const parts = once(async () => {
    await Promise.race([afterCompiler, compiler()]);
    return Promise.all([program("course"), program("judge"), texts("tree/files.json"), texts("figures/files.json")]);
});
// A handout has no reference: an answer is linked with the student's answers before it, by tools.js.
let isHandout = false; // until the judge's plan is there
const judging = once(async () => {
    const [[course, judge, tree, figures], ready] = await Promise.all([parts(), compiler()]);
    const objects = new Map(), tools = toolsOf(ready, objects);
    isHandout = /^stands on\t/m.test(tree.plan);
    return { tools, objects, judge: createJudge({ modules: { course, judge }, files: new Map([...Object.entries(tree), ...Object.entries(figures)]),
        compile: tools.compile, link: isHandout ? tools.linkAnswer : undefined }) };
});
/** What pictures are linked with, and the scenes that they show: after the verdict. */
const picturePack = once(async () => unpack(new Uint8Array(await unzipped("pictures.pack.gz"))));
const casting = once(async () => castLinker(await compiler(), await picturePack()));
const pictures = once(async () => {
    const { judge, objects } = await judging();
    for (const [path, bytes] of await picturePack())
        if (/\.(png|nff)$/.test(path))
            judge.files.put(path, bytes);
        else
            objects.set(path, bytes);
});

/** A chapter is judged by its table; a handout judges those before it as well. */
const table = once(async (stem) => new Uint8Array(await unzipped(`tables/${stem}.table.gz`)));
async function fetchTables(judge, stem, sources) {
    const stems = [...judge.files.text("plan").matchAll(/^chapter\t(.*)$/mg)].map(([, each]) => each);
    const isAsked = (each) => each === stem || isHandout && (each < stem || each in sources);
    await Promise.all(stems.filter(isAsked).map(async (each) => judge.files.put(`tables/${each}.table`, await table(each))));
}

/** What the judge says; once more if it needs the whole compiler for that. */
async function judged(ask) {
    const { judge, tools } = await judging();
    for (;;) {
        try {
            return await ask(judge, tools);
        } catch (reason) {
            if (!(reason instanceof WholeCompilerNeeded))
                throw reason;
            tellProgress("Fetching the whole compiler, once");
            await tools.takeWhole();
        }
    }
}

const compiled = new Map(); // stem -> {text, result}: the last text
async function compile(stem, text) {
    if (isHandout)
        return null;
    if (compiled.get(stem)?.text !== text) {
        const result = compiler().then((ready) => ready.compile({ stem, files: { [`exercises/${stem}.c`]: text } }));
        compiled.set(stem, { text, result });
        result.catch(() => compiled.delete(stem));
    }
    return compiled.get(stem).result;
}

/** How many functions are right, and the state of each, from the lines 'stem, name, state' of course status. */
function countOf(status, stem) {
    const states = Object.fromEntries(status.split("\n").map((line) => line.split("\t")).filter(([of, name]) => of === stem && name !== "").map(([, name, state]) => [name, state]));
    const total = Object.keys(states).length, right = Object.values(states).filter((state) => state === "right").length;
    return { right, total, done: total > 0 && right === total, states };
}

/** All chapters draw a picture, without what the judge counts in an answer. */
async function takeDrawing(judge, given, first, others) {
    const { objectOf } = await casting(), { stem, sources } = given;
    given.compiled = { [stem]: { ...first, object: await objectOf(stem, sources[stem]) ?? first.object } };
    for (const other of others) {
        const object = await objectOf(other, sources[other]);
        if (object)
            judge.files.put(`build/exercises/verdict/${other}/answer.o`, object);
    }
}

const recordOf = (stem) => `build/exercises/verdict/${stem}.record`;

/** A verdict as parts; the figures that it names, as scripts for figure_worker.js, and the pictures. */
function told({ text, errors }, { files }) {
    const parts = text ? partsOf(text) : [{ kind: "compiler", label: "", words: errors }], named = (wanted) => parts.filter(({ kind }) => kind === wanted);
    return { parts, scripts: named("figure").map(({ label }) => files.text(label)).filter(Boolean),
        pictures: named("picture").map(({ label, words }) => ({ bytes: files.get(label), words })).filter(({ bytes }) => bytes) };
}

answerQuestions({
    /** All is fetched, and the text is compiled: the first verdict on it does not wait for that. */
    async prepare({ stem, text }) {
        await Promise.all([judging(), compile(stem, text)]);
        return {};
    },
    async judge({ stem, sources, records, isDrawn = true }) {
        const [{ judge: before }, first] = await Promise.all([judging(), compile(stem, sources[stem])]);
        await fetchTables(before, stem, sources);
        // What was judged on other pages: the verdict counts the functions of all chapters.
        for (const [other, record] of Object.entries(records))
            if (!before.files.get(recordOf(other)))
                before.files.put(recordOf(other), record);
        tellProgress("Judging");
        const result = isHandout ? {} : { [stem]: first };
        const given = { stem, sources, compiled: result, web: true };
        const said = () => result[stem]?.messages ?? before.files.text(`build/exercises/verdict/${stem}/compiler`) ?? "";
        const answer = async (verdict) => ({ ...told(verdict, before), record: verdict.record, messages: said(),
            ...countOf(await judged((judge) => judge.status([stem]).text), stem) });
        const verdict = await judged((judge) => judge.judge(given));
        if (!verdict.needs || !isDrawn)
            return answer(verdict);
        // The verdict at once; the pictures that the answer draws when they are linked.
        tellProgress("Drawing", 0, 0, await answer(verdict));
        await pictures();
        if (!isHandout)
            await takeDrawing(before, given, first, Object.keys(records));
        return answer(await judged((judge, tools) => judge.draw(given, async (words, files) => tools.link(words, files))));
    },
    /** A program that casts (cast/cast.c) with these answers: a WebAssembly.Module. */
    async program({ answers, isRace }) {
        return (await casting()).link(answers, isRace);
    },
    async hint({ stem, sources, state }) {
        const { judge: before } = await judging();
        await fetchTables(before, stem, sources);
        const path = `build/exercises/verdict/${stem}.hint`, result = isHandout ? {} : { [stem]: await compile(stem, sources[stem]) };
        const { text, errors, kept } = await judged((judge) => {
            if (state && !judge.files.get(path))
                judge.files.put(path, state);
            return { ...judge.hint(stem, { sources, compiled: result }), kept: judge.files.text(path) };
        });
        return { ...told({ text, errors }, before), state: kept ?? "" };
    },
}, async () => (await compiler()).warm());
