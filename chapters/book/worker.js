// worker.js - what takes time, beside the page: the compiler, the judge, gnuplot. A question is {id, do, ...}; the
// answer has the same id (page/helper.js). What a question needs is fetched when it is first asked.

const site = new URL(".", self.location.href);

const answers = {
    async prepare() {},
    async judge() { throw new Error("the judge is not part of this build"); },
    async hint() { throw new Error("the judge is not part of this build"); },
    async figure() { throw new Error("live figures are not part of this build"); },
};

addEventListener("message", async ({ data: { id, do: what, ...question } }) => {
    const progress = (words, done = 0, all = 0) => postMessage({ id, kind: "progress", words, done, all });
    try {
        postMessage({ id, kind: "answer", ...(await answers[what](question, progress)) });
    } catch (reason) {
        postMessage({ id, kind: "failed", words: String(reason?.message ?? reason) });
    }
});
