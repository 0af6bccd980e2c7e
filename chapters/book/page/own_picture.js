// own_picture.js - the picture of the start page, cast in the page: by the reference, and from the first right answer on
// by the student's functions.
import { openView, sceneOf } from "../cast/scene_view.js";
import { Helper, program } from "../worker_questions.js";
import { element, saveAs } from "./verdict.js";

const NAMED = 8; // functions that are named under the picture

function credit(yours, total) {
    if (yours.length === 0)
        return "Cast just now, in this page, by the reference: your functions will take its place.";
    if (yours.length === total)
        return "Drawn by your own code.";
    const named = yours.slice(-NAMED), more = yours.length - named.length;
    return `Yours, ${yours.length} of ${total} functions: ${more > 0 ? `${more} more, ` : ""}${named.join(", ")}. By the reference: the others.`;
}

/** @returns {() => Promise<void>} to call when answers have changed */
export function setUpOwnPicture({ place, site, course, answers }) {
    const still = place.querySelector("img"), total = Object.values(course.functions).flat().length;
    const canvas = element("canvas", { width: 1280, height: 720, tabindex: 0, hidden: "", role: "img",
        "aria-label": `${still.alt}. Arrow keys turn it, plus and minus go closer and farther away.` });
    const words = element("p", { class: "credit", role: "status" }), button = element("button", { type: "button", hidden: "" }, "Save the picture");
    button.addEventListener("click", () => canvas.toBlob((blob) => saveAs("ray-casting.png", blob)));
    place.querySelector("figcaption").append(words, button);
    still.after(canvas);

    let yours = [], shown = "";
    const view = openView(canvas, site, {
        samples: 2,
        onPicture(isFine) {
            canvas.toggleAttribute("data-fine", isFine);
            button.hidden = !(isFine && yours.length === total);
            canvas.hidden = false; // until the first fine picture, the one that the page came with is better
            still.hidden = true;
            words.textContent = credit(yours, total);
        },
        onView() { button.hidden = true; },
        onTrouble(trouble) {
            if (trouble)
                words.textContent = `The picture could not be cast: ${trouble}.`;
        },
    });
    async function begin() {
        const [reference, scene] = await Promise.all([program("cast"), sceneOf("finale")]);
        await view.show({ program: reference, scene });
    }
    const ready = begin();
    return async function follow() {
        await ready;
        const right = answers.right(course.stems), name = JSON.stringify(right);
        if (name === shown || Object.keys(right).length === 0)
            return;
        shown = name;
        const helper = new Helper(() => new Worker(new URL("judge_worker.js", site), { type: "module" }));
        const linked = await helper.ask({ do: "program", answers: right }, ({ words: doing, done, all }) => {
            words.textContent = all > 0 ? `${doing}, ${(done / 1e6).toFixed(1)} of ${(all / 1e6).toFixed(1)} MB, to draw with your answers.` : words.textContent;
        }).finally(() => helper.stop("the program is there", false));
        if (name !== shown)
            return;
        yours = linked.yours;
        await view.show({ program: linked.module, keepsView: true });
    };
}
