// worker_questions.js - what both Workers do: they fetch files of the site, and answer the page's questions. A question
// is {id, do, ...}; the answer has the same id (page/helper.js).
const ALIVE = 5000; // milliseconds between signs of life: without them the page ends a Worker
const site = new URL(".", self.location.href);

export async function fetched(name) {
    const response = await fetch(new URL(name, site)).catch(() => { throw new Error(`${name} could not be fetched. Is there a network?`); });
    if (!response.ok)
        throw new Error(`${name} could not be fetched: the host says ${response.status}`);
    return response;
}

/** What is fetched or made once; again if that failed. */
export function once(make) {
    const made = new Map();
    return (name = "", ...more) => {
        if (!made.has(name))
            made.set(name, make(name, ...more).catch((reason) => { made.delete(name); throw reason; }));
        return made.get(name);
    };
}

export const program = once(async (name) => WebAssembly.compileStreaming(await fetched(`programs/${name}.wasm`)));
export const texts = once(async (name) => (await fetched(name)).json());
export const unzipped = async (name) => new Response((await fetched(name)).body.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();

let newest = () => {};
/** Tells the page how far the newest question is; first: an answer that is not complete yet. */
export const tellProgress = (words, done = 0, all = 0, first = null) => newest(words, done, all, first);

/**
 * @param {Object<string, (question: object) => Promise<object>>} answers by the name of a question
 * @param {() => Promise<void>} [whenIdle] called when every question is answered
 */
export function answerQuestions(answers, whenIdle = async () => {}) {
    let open = 0, sign = null;
    addEventListener("message", async ({ data: { id, do: what, ...question } }) => {
        newest = (words, done, all, first) => postMessage({ id, kind: "progress", words, done, all, first });
        // A Worker that waits for the network gives signs of life; one that computes without an end does not.
        if (open++ === 0)
            sign = setInterval(() => postMessage({ kind: "alive" }), ALIVE);
        try {
            postMessage({ id, kind: "answer", ...(await answers[what](question)) });
        } catch (reason) {
            postMessage({ id, kind: "failed", words: String(reason?.message ?? reason) });
        }
        if (--open === 0) {
            clearInterval(sign);
            setTimeout(() => { if (open === 0) whenIdle().catch(() => {}); });
        }
    });
}
