// mistakes.js - the gallery of a chapter: a scene cast by a known mistake (cast/mistaken.c); the student guesses the line, sees
// why it is wrong, and what the other lines would have drawn.
import { openView, sceneOf } from "../cast/scene_view.js";
import { program, unzipped } from "../worker_questions.js";
import { element, sentence } from "./verdict.js";

const $ = (id) => document.getElementById(id);
const NONE = -1;
/** Who calls a function that the usual casters do not call. Before chapter 07 pictures are flat. */
const CASTERS = { cast_object_order: "object order", sphere_rectangle: "object" };
const casterOf = ({ stem, function: name }) => CASTERS[name] ?? (stem < "07" ? "image order" : "");

/** @typedef {{number: number, stem: string, function: string, formula: string, why: string, picture: string}} Mistake */

export function setUpMistakes({ site, course, answers, showTrouble }) {
    /** @type {Mistake[][]} the questions of the chapter; the first mistake of each is the one that casts */
    let questions = [];
    let at = 0, seen = null, view = null;

    async function begin() {
        view = openView($("question").querySelector("canvas"), site, {
            onPicture(isFine) { view.canvas.toggleAttribute("data-fine", isFine); },
            onTrouble: (trouble) => showTrouble(trouble && sentence(trouble)),
        });
        const [casting, scene, questionsOf] = await Promise.all([program("mistaken"), sceneOf("three-spheres"), unzipped("mistakes.json.gz")]);
        return { program: casting, scene, all: JSON.parse(new TextDecoder().decode(questionsOf)) };
    }
    let ready = null;

    /** The chapter of the address; else the last one that is done. */
    async function openChapter() {
        const isDone = (stem) => answers.verdict(stem)?.done;
        const stem = course.stems.find((each) => location.hash === `#${each}`) ?? course.stems.findLast(isDone) ?? course.stems[0];
        for (const link of document.querySelectorAll(".chapters a"))
            link.setAttribute("aria-current", String(link.hash === `#${stem}`));
        $("question").hidden = !isDone(stem);
        $("closed").replaceChildren();
        if (!isDone(stem)) {
            const states = answers.verdict(stem)?.states ?? {}, missing = course.functions[stem].filter((name) => states[name] !== "right");
            $("closed").append("Not open yet. ", element("a", { href: `${stem}.html#exercise` }, course.titles[stem]), ` still needs: ${missing.join(", ")}.`);
            return;
        }
        const { all, ...opened } = await (ready ??= begin());
        questions = all[stem];
        view.opened = opened;
        ask(0);
    }

    function ask(number) {
        const [drawn, ...others] = questions[at = number];
        let isFound = false;
        view.view = null;
        const choices = [drawn, ...others].sort((a, b) => a.formula < b.formula ? -1 : 1).map((choice) => {
            const button = element("button", { type: "button" }, element("code", {}, choice.formula)), words = element("p", {});
            const says = (text) => { words.textContent = text; };
            button.addEventListener("click", () => {
                if (choice === drawn || isFound)
                    show(choice);
                if (choice === drawn && !isFound) {
                    isFound = true;
                    choices.forEach((each) => each.says(`${each.choice === drawn ? "This line. " : `${sentence(each.choice.picture)} `}${sentence(each.choice.why)}`));
                    button.classList.add("found");
                } else if (!isFound) {
                    says(`Not this one. It would show: ${sentence(choice.picture)}`);
                }
            });
            return { choice, says, item: element("li", {}, button, words) };
        });
        $("choices").replaceChildren(...choices.map(({ item }) => item));
        $("asked").replaceChildren("Which line of ", element("code", {}, drawn.function), " was it?");
        $("of").textContent = `${at + 1} of ${questions.length}`;
        $("back").disabled = at === 0;
        $("next").disabled = at === questions.length - 1;
        show(drawn);
    }

    function show(mistake, isRight = false) {
        seen = mistake;
        $("by").textContent = isRight ? "As it should be." : `By a wrong ${mistake.function}.`;
        $("compare").setAttribute("aria-pressed", String(isRight));
        view.canvas.removeAttribute("data-fine");
        view.caster = casterOf(mistake);
        view.mistake = isRight ? NONE : mistake.number;
        view.draw(true);
    }

    $("compare").addEventListener("click", () => show(seen, $("compare").getAttribute("aria-pressed") === "false"));
    $("back").addEventListener("click", () => ask(at - 1));
    $("next").addEventListener("click", () => ask(at + 1));
    const open = () => openChapter().catch((reason) => { ready = null; showTrouble(`The gallery could not be opened: ${reason.message}.`); });
    addEventListener("hashchange", open);
    return open();
}
