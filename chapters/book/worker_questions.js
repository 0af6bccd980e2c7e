// worker_questions.js - questions of the page to a Worker, and its answers. A question is {id, do, ...}; the answer has the
// same id. First what the Workers do, which also fetch files of the site; then the page's side.
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

/** @type {(...progress: any[]) => void} */
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
            setTimeout(() => {
                if (open === 0)
                    whenIdle().catch(() => {});
            });
        }
    });
}

// ---- in the page ----------------------------------------------------------------------------------

const SILENT = 30_000; // milliseconds without a sign of life

/** The Worker was ended. isBusy: it was computing for too long; otherwise it stopped by itself, and may work next time. */
export class Stopped extends Error {
    constructor(why, isBusy) {
        super(why);
        this.isBusy = isBusy;
    }
}

/** A Worker that is started when it is first asked, and again if it stops, or computes for so long that it will probably never end. */
export class Helper {
    /** @param {() => Worker} start */
    constructor(start) {
        this.start = start;
        this.asked = new Map();
        this.count = 0;
    }

    /** @returns {Promise<object>} the answer; an Error if there is none, Stopped if the Worker was ended */
    ask(what, onProgress = () => {}) {
        if (!this.worker) {
            this.worker = this.start();
            this.worker.addEventListener("message", ({ data }) => this.hear(data));
            this.worker.addEventListener("error", (event) => { event.preventDefault(); this.stop(event.message || "it stopped", false); });
        }
        return new Promise((resolve, reject) => {
            const id = ++this.count;
            this.asked.set(id, { resolve, reject, onProgress });
            this.watch();
            this.worker.postMessage({ ...what, id });
        });
    }

    hear({ id, kind, ...rest }) {
        const asked = this.asked.get(id);
        this.watch();
        if (kind === "progress") {
            asked?.onProgress(rest);
        } else if (asked) {
            this.asked.delete(id);
            this.watch();
            if (kind === "failed")
                asked.reject(new Error(rest.words));
            else
                asked.resolve(rest);
        }
    }

    watch() {
        clearTimeout(this.timer);
        if (this.asked.size > 0)
            this.timer = setTimeout(() => this.stop(`it computed for ${SILENT / 1000} seconds without an end`, true), SILENT);
    }

    /** Ends the worker. Those who wait are told; the next question starts another. */
    stop(why, isBusy) {
        clearTimeout(this.timer);
        this.worker?.terminate();
        this.worker = null;
        const waiting = [...this.asked.values()];
        this.asked.clear();
        waiting.forEach(({ reject }) => reject(new Stopped(why, isBusy)));
    }
}

const UNUSED = 10_000; // milliseconds, after which the second Worker is ended

/** Draws figures, and those that say `beside`, as while something is dragged, two at a time. */
export class Drawer extends Helper {
    second = new Helper(this.start);
    isReady = false;

    ask({ beside, ...what }, onProgress) {
        if (!beside)
            return super.ask(what, onProgress);
        if (!this.second.worker) {
            this.isReady = false;
            this.second.ask(what).then(() => { this.isReady = true; }, () => {});
        }
        clearTimeout(this.unused);
        this.unused = setTimeout(() => this.second.stop("it is not used any more", false), UNUSED);
        return this.isReady && this.asked.size > 0 ? this.second.ask(what, onProgress) : super.ask(what, onProgress);
    }
}
