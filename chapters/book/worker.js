// worker.js - what takes time, beside the page: the compiler, the judge, gnuplot. A question is {id, do, ...}; the
// answer has the same id (page/helper.js). What a question needs is fetched when it is first asked.
import { linkPicture, load, unpack } from "./compiler.js";
import { loadFigures } from "./figure.js";
import { createJudge } from "./judge.js";

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
const unpacked = async (name) => WebAssembly.compileStreaming(new Response(
    (await fetched(name)).body.pipeThrough(new DecompressionStream("gzip")), { headers: { "content-type": "application/wasm" } }));

// ---- figures ------------------------------------------------------------------------------------

const figures = once(async () => {
    const [gnuplot, finish, files] = await Promise.all([unpacked("figures/gnuplot.wasm.gz"), program("finish_figure"), texts("figures/files.json")]);
    return loadFigures({ gnuplot, finish, files });
});

// ---- verdicts -----------------------------------------------------------------------------------

let hearProgress = () => {};
const compiler = once(() => load({ fetchBytes: fetched, progress: (done, all) => hearProgress("Fetching the compiler", done, all) }));
const judging = once(async () => {
    const [course, judge, files] = await Promise.all([program("course"), program("judge"), texts("tree/files.json")]);
    return createJudge({ modules: { course, judge }, files: new Map(Object.entries(files)) });
});

// What the pictures of an answer are linked with.
const pictureParts = once(async () => unpack(new Uint8Array(await new Response(
    (await fetched("pictures.pack.gz")).body.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer())));

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
        await Promise.all([judging(), compiler()]);
        return {};
    },
    async judge({ stem, sources, theme, columns }) {
        const [judge] = await Promise.all([judging(), compiler()]);
        hearProgress("Judging");
        const result = { [stem]: await compile(stem, sources[stem]) };
        const verdict = judge.judge({ stem, sources, compiled: result, columns });
        return { text: verdict.text || verdict.errors, messages: result[stem].messages, ...countOf(judge.status([stem]).text, stem), draws: Boolean(verdict.needs), pictures: await picturesOf(verdict, theme) };
    },
    /** The same verdict with the pictures that the answer draws, if judge said that it draws some. */
    async draw({ stem, sources, theme, columns }) {
        const judge = await judging(), result = { [stem]: await compile(stem, sources[stem]) };
        const verdict = await judge.draw({ stem, sources, compiled: result, columns },
            async (words, files) => linkPicture(await compiler(), await pictureParts(), words, files));
        return { text: verdict.text, pictures: await picturesOf(verdict, theme) };
    },
    async hint({ stem, sources, state }) {
        const judge = await judging();
        const path = `build/exercises/verdict/${stem}.hint`;
        if (state)
            judge.files.put(path, state);
        const { text, errors } = judge.hint(stem, { sources, compiled: { [stem]: await compile(stem, sources[stem]) } });
        return { text: text || errors, state: judge.files.text(path) ?? "" };
    },
    async figure({ stem, name, ...wanted }) {
        return (await figures()).drawMoved({ program: await program(stem), stem, name, ...wanted });
    },
};

addEventListener("message", async ({ data: { id, do: what, ...question } }) => {
    const progress = (words, done = 0, all = 0) => postMessage({ id, kind: "progress", words, done, all });
    hearProgress = progress;
    try {
        postMessage({ id, kind: "answer", ...(await answers[what](question)) });
    } catch (reason) {
        postMessage({ id, kind: "failed", words: String(reason?.message ?? reason) });
    }
});
