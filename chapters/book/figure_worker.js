// figure_worker.js - draws figures beside the page: a chapter's program, and gnuplot.
import { lessonNumbers, loadFigures } from "./figure.js";
import { answerQuestions, fetched, once, program, tellProgress, texts } from "./worker_questions.js";
import xz from "xz-decompress";

async function gnuplotModule() {
    const bytes = new xz.XzReadableStream((await fetched("figures/gnuplot.wasm.xz")).body);
    const module = await WebAssembly.compileStreaming(new Response(bytes, { headers: { "content-type": "application/wasm" } }));
    Object.assign(xz.XzReadableStream, { _moduleInstance: undefined, _moduleInstancePromise: undefined }); // its memory is not needed again
    return module;
}
const figures = once(async () => {
    const [gnuplot, files] = await Promise.all([gnuplotModule(), texts("figures/files.json")]);
    return loadFigures({ gnuplot, files });
});

answerQuestions({
    async figure({ stem, name, ...wanted }) {
        const [drawing, chapter] = await Promise.all([figures(), program(stem)]);
        tellProgress("Drawing"); // all is fetched (page/figures.js)
        return drawing.drawMoved({ program: chapter, stem, name, ...wanted });
    },
    /** A figure of a verdict, whose script the judge has written. */
    async script({ script, ...wanted }) {
        return (await figures()).drawScript(script, wanted);
    },
    async numbers({ name, options }) {
        return { numbers: lessonNumbers(await program("numbers"), name, options) };
    },
});
