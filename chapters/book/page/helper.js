// helper.js - a Worker as an object of questions and answers: it is started when it is first asked, and started again
// if it stops, or computes for so long that it will probably never end.

const SILENT = 30_000; // milliseconds without a sign of life (worker_questions.js)

/** The Worker was ended. isBusy: it was computing for too long; otherwise it stopped by itself, and may work next time. */
export class Stopped extends Error {
    constructor(why, isBusy) {
        super(why);
        this.isBusy = isBusy;
    }
}

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
