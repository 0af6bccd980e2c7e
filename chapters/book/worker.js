// worker.js - what takes time, beside the page: the compiler, the judge, gnuplot. A question is {id, do, ...}; the
// answer has the same id (page/helper.js). What a question needs is fetched when it is first asked.
import { load, unpack } from "./compiler.js";
import { loadFigures } from "./figure.js";
import { createJudge } from "./judge.js";
import { lessonNumbers } from "./lesson_numbers.js";
import { toolsOf, WholeCompilerNeeded } from "./tools.js";
import xz from "xz-decompress";

const site = new URL(".", self.location.href);

async function fetched(name) {
    const response = await fetch(new URL(name, site)).catch(() => { throw new Error(`${name} could not be fetched. Is there a network?`); });
    if (!response.ok)
        throw new Error(`${name} could not be fetched: the host says ${response.status}`);
    return response;
}

/** What is fetched or made once; again if that failed. */
function once(make) {
    const made = new Map();
    return (name = "", ...more) => {
        if (!made.has(name))
            made.set(name, make(name, ...more).catch((reason) => { made.delete(name); throw reason; }));
        return made.get(name);
    };
}

const program = once(async (name) => WebAssembly.compileStreaming(await fetched(`programs/${name}.wasm`)));
const texts = once(async (name) => (await fetched(name)).json());
const unzipped = async (name) => new Response((await fetched(name)).body.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();

// ---- figures ------------------------------------------------------------------------------------

async function gnuplotModule() {
    const bytes = new xz.XzReadableStream((await fetched("figures/gnuplot.wasm.xz")).body);
    return WebAssembly.compileStreaming(new Response(bytes, { headers: { "content-type": "application/wasm" } }));
}
const figures = once(async () => {
    const [gnuplot, finish, files] = await Promise.all([gnuplotModule(), program("finish_figure"), texts("figures/files.json")]);
    return loadFigures({ gnuplot, finish, files });
});

// ---- verdicts -----------------------------------------------------------------------------------

let hearProgress = () => {};
const compiler = once(() => load({ fetchBytes: fetched, progress: (done, all) => hearProgress("Fetching the compiler", done, all) }));
const judging = once(async () => {
    const [course, judge, texts1, texts2, pack, ready] = await Promise.all([program("course"), program("judge"), texts("tree/files.json"), texts("figures/files.json"),
        unzipped("pictures.pack.gz"), compiler()]);
    const pictures = unpack(new Uint8Array(pack)), tools = toolsOf(ready, pictures);
    const files = new Map([...Object.entries(texts1), ...Object.entries(texts2), ...[...pictures].filter(([path]) => /\.(png|nff)$/.test(path))]);
    // A handout has no reference: an answer is linked with the student's answers before it.
    const isHandout = /^stands on\t/m.test(texts1.plan);
    return { judge: createJudge({ modules: { course, judge }, files, compile: tools.compile, link: isHandout ? tools.linkAnswer : undefined }), tools, isHandout };
});

/** A handout judges a chapter, and those before it, by tables. */
const table = once(async (stem) => new Uint8Array(await (await unzipped(`tables/${stem}.table.gz`, "text/plain")).arrayBuffer()));
async function fetchTables(judge, stem, sources) {
    const stems = [...judge.files.text("plan").matchAll(/^chapter\t(.*)$/mg)].map(([, each]) => each);
    await Promise.all(stems.filter((each) => each <= stem || each in sources).map(async (each) => judge.files.put(`tests/handout/replay/${each}.table`, await table(each))));
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
            hearProgress("Fetching the whole compiler, once");
            await tools.takeWhole();
        }
    }
}

const compiled = new Map(); // stem -> {text, result}
async function compile(stem, text) {
    const before = compiled.get(stem);
    if (before?.text === text)
        return before.result;
    const result = await (await compiler()).compile({ stem, files: { [`exercises/${stem}.c`]: text } });
    compiled.set(stem, { text, result });
    return result;
}

/** How many functions are right, from the lines 'stem, name, state' of course status. */
function countOf(status, stem) {
    const states = status.split("\n").map((line) => line.split("\t")).filter(([of, name]) => of === stem && name !== "").map(([, , state]) => state);
    const right = states.filter((state) => state === "right").length;
    return { right, total: states.length, done: states.length > 0 && right === states.length };
}

const recordOf = (stem) => `build/exercises/verdict/${stem}.record`;
const isNamedIn = (text, name) => text.includes(`/${name}`);

/** The student's figures and pictures that a verdict names. */
async function picturesOf({ text, figures: scripts, pictures }, theme) {
    const shown = [];
    for (const [name, script] of Object.entries(scripts))
        if (isNamedIn(text, `${name}.svg`)) {
            const { svg, words } = (await figures()).drawScript(script, { theme });
            shown.push({ bytes: new TextEncoder().encode(svg), type: "image/svg+xml", words, caption: "Yours is dashed, beside the right one." });
        }
    for (const [name, bytes] of Object.entries(pictures))
        if (isNamedIn(text, `${name}.png`))
            shown.push({ bytes, type: "image/png", words: `The picture that your code draws: ${name}`, caption: "" });
    return shown;
}

const answers = {
    async prepare() {
        await judging();
        return {};
    },
    async judge({ stem, sources, records, theme, columns }) {
        const { judge: before, isHandout } = await judging();
        if (isHandout)
            await fetchTables(before, stem, sources);
        // What was judged on other pages: the verdict counts the functions of all chapters.
        for (const [other, record] of Object.entries(records))
            if (!before.files.get(recordOf(other)))
                before.files.put(recordOf(other), record);
        hearProgress("Judging");
        const result = isHandout ? {} : { [stem]: await compile(stem, sources[stem]) };
        const given = { stem, sources, compiled: result, columns };
        const said = () => result[stem]?.messages ?? before.files.text(`build/exercises/verdict/${stem}/compiler`) ?? "";
        const told = async (verdict) => ({ text: verdict.text || verdict.errors, record: verdict.record, messages: said(),
            ...countOf(await judged((judge) => judge.status([stem]).text), stem), pictures: await picturesOf(verdict, theme) });
        const verdict = await judged((judge) => judge.judge(given));
        if (!verdict.needs)
            return told(verdict);
        // The verdict at once; the pictures that the answer draws when they are linked.
        hearProgress("Drawing", 0, 0, await told(verdict));
        return told(await judged((judge, tools) => judge.draw(given, async (words, files) => tools.link(words, files))));
    },
    async hint({ stem, sources, state }) {
        const { judge: before, isHandout } = await judging();
        if (isHandout)
            await fetchTables(before, stem, sources);
        const path = `build/exercises/verdict/${stem}.hint`, result = isHandout ? {} : { [stem]: await compile(stem, sources[stem]) };
        const { text, errors, kept } = await judged((judge) => {
            if (state && !judge.files.get(path))
                judge.files.put(path, state);
            return { ...judge.hint(stem, { sources, compiled: result }), kept: judge.files.text(path) };
        });
        return { text: text || errors, state: kept ?? "" };
    },
    async numbers({ stem, name, options }) {
        return { numbers: lessonNumbers(await program(`${stem}-numbers`), name, options) };
    },
    async figure({ stem, name, ...wanted }) {
        const [drawing, chapter] = await Promise.all([figures(), program(stem)]);
        hearProgress("Drawing"); // all is fetched (page/figures.js)
        return drawing.drawMoved({ program: chapter, stem, name, ...wanted });
    },
};

addEventListener("message", async ({ data: { id, do: what, ...question } }) => {
    const progress = (words, done = 0, all = 0, first = null) => postMessage({ id, kind: "progress", words, done, all, first });
    hearProgress = progress;
    try {
        postMessage({ id, kind: "answer", ...(await answers[what](question)) });
    } catch (reason) {
        postMessage({ id, kind: "failed", words: String(reason?.message ?? reason) });
    }
});
