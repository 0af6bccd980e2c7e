// helper.js - a Worker as an object of questions and answers: it is started when it is first asked, and started again
// if it stops or says nothing for too long.

const SILENT = 30_000; // milliseconds without an answer or a word about progress

export class Stopped extends Error {}

export class Helper {
    /** @param {() => Worker} start */
    constructor(start) {
        this.start = start;
        this.asked = new Map();
        this.count = 0;
    }

    /** Fetches and prepares what a later question needs. */
    ask(what, onProgress = () => {}) {
        if (!this.worker) {
            this.worker = this.start();
            this.worker.addEventListener("message", ({ data }) => this.hear(data));
            this.worker.addEventListener("error", (event) => { event.preventDefault(); this.stop(event.message || "it stopped"); });
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
            this.timer = setTimeout(() => this.stop(`it did not answer for ${SILENT / 1000} seconds`), SILENT);
    }

    /** Ends the worker. Those who wait are told; the next question starts another. */
    stop(why) {
        clearTimeout(this.timer);
        this.worker?.terminate();
        this.worker = null;
        const waiting = [...this.asked.values()];
        this.asked.clear();
        waiting.forEach(({ reject }) => reject(new Stopped(why)));
    }
}
