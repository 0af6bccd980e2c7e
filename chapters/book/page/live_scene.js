// live_scene.js - a scene beside the exercise, cast by the student's functions while they write, right or wrong: turned,
// its spheres and lights dragged, another scene chosen or written, and one pixel explained.
import { beside, moved, numbersOf, seen, thingsOf, viewOf, withThing } from "../cast/scene.js";
import { openView, sceneOf } from "../cast/scene_view.js";
import { program } from "../worker_questions.js";
import { drawStory, storyOf } from "./pixel_story.js";
import { RACERS, setUpRace } from "./race.js";
import { showView } from "./room.js";
import { element, saveAs } from "./verdict.js";

const FIRST = "three-spheres", OWN = "your own";
const SCENES = { [FIRST]: "three spheres", "sphereflake-91": "91 spheres", "sphereflake-820": "820 spheres", sunflower: "a sunflower", finale: "the finale" };
/** Who casts, besides trace_ray: functions of the exercise whose picture is flat, and chapter 08's engines. The first calls the exercise. */
const CASTERS = { "06-ray-casting": ["image order", "object order"], "08-fast": ["object", ...Object.keys(RACERS).filter((each) => each !== "object")] };
const MOST_HANDLES = 9, LONGEST_LINK = 12_000;
const A_KEY = 0.01; // how far an arrow key moves a thing, in parts of the picture's width
const KEYS = { ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, -1, 0], ArrowDown: [0, 1, 0], "+": [0, 0, 3], "=": [0, 0, 3], "-": [0, 0, -3] };

const button = (words, whenClicked) => {
    const made = element("button", { type: "button" }, words);
    made.addEventListener("click", whenClicked);
    return made;
};

// ---- a scene in a link ------------------------------------------------------------------------------

const through = async (bytes, stream) => new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
async function packed(what) {
    const bytes = await through(JSON.stringify(what), new CompressionStream("deflate-raw"));
    return btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replace(/=*$/, "");
}
async function unpacked(words) {
    const bytes = Uint8Array.from(atob(words.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
    return JSON.parse(new TextDecoder().decode(await through(bytes, new DecompressionStream("deflate-raw"))));
}

/**
 * @param {{stem: string, site: URL, course: object, answers: object, ask: (what: object) => Promise<any>}} given ask: judge_worker.js
 * @returns {{follow: () => void}} to call when the answer was judged
 */
export function setUpLiveScene({ stem, site, course, answers, ask }) {
    const chapterOf = Object.fromEntries(Object.entries(course.functions).flatMap(([of, names]) => names.map((name) => [name, of])));
    const canvas = element("canvas", { width: 320, height: 240, tabindex: 0, role: "img",
        "aria-label": "The scene. Arrow keys turn it, plus and minus go closer and farther away, W, A, S, D, Q and E fly. Click a pixel for its story." });
    const mark = element("span", { class: "pixel-mark", hidden: "" }), handles = element("div", { class: "handles" });
    const rays = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    rays.setAttribute("viewBox", "-0.5 -0.375 1 0.75");
    rays.setAttribute("aria-hidden", "true"); // the story has it in words
    const credit = element("span", { class: "credit", role: "status" }), wrong = element("p", { class: "note", role: "alert", hidden: "" }), took = element("span", { class: "state" });
    const option = (value, words) => element("option", { value }, words);
    const scenes = element("select", {}, ...Object.entries(SCENES).map(([value, words]) => option(value, words)), option(OWN, OWN));
    const casters = element("select", {}, ...[...CASTERS[stem] ?? [], ""].map((value) => option(value, value || "trace_ray")));
    const pixelInput = element("input", { placeholder: "160,120", autocomplete: "off" }), turn = button("From beside", () => turnAside());
    turn.hidden = true;
    const written = element("div", { class: "scene-text", hidden: "" }), story = element("div", { class: "story", tabindex: 0, hidden: "", "aria-label": "The story of the pixel" });
    const actions = element("div", { class: "actions" }, element("label", {}, "Scene ", scenes), ...casters.length > 1 ? [element("label", {}, "by ", casters)] : [],
        button("Write", () => write().catch((reason) => tell(reason.message))), button("Link", () => link().catch((reason) => tell(reason.message))),
        button("Save", () => canvas.toBlob((blob) => saveAs("scene.png", blob))), element("label", {}, "pixel ", pixelInput), took);
    const details = element("details", { class: "live-scene" }, element("summary", {}, "A scene, cast by your code ", credit),
        actions, wrong, element("div", { class: "live-body" }, element("div", { class: "stage" }, canvas, rays, handles, mark), element("div", { class: "live-side" }, written, turn, story)));

    const race = stem in CASTERS ? setUpRace({ site, link: async () => (await ask({ do: "program", answers: wanted(), isRace: true })).module,
        seen: () => ({ scene: text, view: numbersOf(home ?? view.view) }) }) : null;
    if (race) {
        actions.insertBefore(button("Race", () => race.start().catch((reason) => { race.stop(); tell(reason.message); })), took);
        details.append(race.section);
        document.querySelector("#editor").addEventListener("input", race.stop); // the next edit
    }

    // ---- the picture -----------------------------------------------------------------------------

    let text = "", name = "", things = [], editor = null, pixel = null, from = null, segments = [];
    let home = null; // whose pixel is explained, while it is seen from beside
    const tell = (words) => { wrong.textContent = words; wrong.hidden = words === ""; };
    const view = openView(canvas, site, {
        onPicture(isFine, milliseconds) {
            canvas.toggleAttribute("data-fine", isFine);
            took.textContent = isFine ? `${Math.round(milliseconds)} ms` : "";
            placeHandles();
            if (isFine)
                explain();
        },
        onView() { placeHandles(); },
        onPoint(chosen) {
            if (!home)
                explain(chosen);
        },
        onTrouble(trouble) {
            const [, line, what] = /^line (\d+): (.*)/.exec(trouble) ?? [];
            editor?.mark(line ? [{ line: Number(line), column: 1, severity: "error", message: what }] : []);
            tell(trouble && (line ? `The scene, ${trouble}.` : `There is no picture: ${trouble}.`));
        },
    });

    /** Another scene; its viewpoint, or the one that is there. */
    function show(other, { keepsView = false, isFromEditor = false, isOwn = true } = {}) {
        text = other;
        things = thingsOf(text);
        if (isOwn)
            scenes.value = name = OWN;
        if (editor && !isFromEditor)
            editor.replace(text);
        if (home && !keepsView)
            setHome(null);
        draw({ scene: text, keepsView });
    }
    function draw(what) {
        canvas.removeAttribute("data-fine");
        race?.stop();
        view.show(what);
    }
    async function choose(chosen) {
        name = scenes.value = chosen;
        if (chosen !== OWN)
            show(await sceneOf(chosen), { isOwn: false });
    }
    const viewpoint = (of) => of.split("\n").filter((line) => /^\s*(from|at|up|angle)\b/.test(line)).join();

    /** The text of the scene, to be changed: the first time, the editor is fetched. */
    async function write() {
        written.hidden = !written.hidden;
        if (!editor) {
            const { openEditor } = await import("./editor.js");
            editor = openEditor({ place: written, contract: "", text, label: "The scene, in NFF. Escape and then Tab leaves the editor.",
                onJudge() {}, onChange: (other) => show(other, { keepsView: viewpoint(other) === viewpoint(text), isFromEditor: true }) });
        }
        if (!written.hidden)
            editor.focus();
    }
    async function link() {
        const hash = `#scene=${await packed({ ...name === OWN ? { text } : { name }, view: view.view && numbersOf(home ?? view.view) })}`;
        if (hash.length > LONGEST_LINK)
            throw new Error("This scene is too long for a link.");
        history.replaceState(null, "", hash);
        await navigator.clipboard?.writeText(location.href).catch(() => {}); // it is in the address as well
        took.textContent = "The link is in the address.";
    }

    // ---- whose functions cast it -------------------------------------------------------------------

    let linked = null, linking = false;
    /** All right answers of the other chapters; of this one what is answered, right or not. */
    function wanted() {
        const used = answers.right(course.stems.filter((other) => other !== stem)), states = answers.verdict(stem)?.states ?? {};
        const mine = Object.keys(states).filter((each) => states[each] !== "unanswered");
        return mine.length > 0 ? { ...used, [stem]: { text: answers.text(stem), used: mine } } : used;
    }
    async function follow() {
        const given = wanted(), key = JSON.stringify(given);
        if (linking || !details.open || key === linked)
            return;
        linking = true;
        try {
            const made = Object.keys(given).length === 0 ? { module: await program("cast"), yours: [] } : await ask({ do: "program", answers: given });
            linked = key;
            const states = answers.verdict(stem)?.states ?? {}, yours = made.yours.map((each) => ["right", undefined].includes(states[each]) ? each : `${each} (not right yet)`);
            credit.textContent = yours.length === 0 ? "By the reference: your functions will take its place." : yours.length === Object.keys(chapterOf).length ? "Cast by your own code."
                : `Yours: ${yours.slice(-5).reverse().join(", ")}${yours.length > 5 ? ` and ${yours.length - 5} more` : ""}. The others are the reference's.`;
            credit.classList.toggle("not-right", /not right/.test(credit.textContent));
            draw({ program: made.module, keepsView: true });
        } catch (reason) {
            tell(`Your code could not be linked: ${reason.message}.`);
        }
        linking = false;
        if (JSON.stringify(wanted()) !== key)
            follow();
    }

    // ---- spheres and lights, dragged ---------------------------------------------------------------

    function placeHandles() {
        if (view.view && pixel)
            drawStory(rays, segments, view.view, home ?? view.view, canvas, pixel);
        const shown = things.filter(({ kind }) => kind === "l" || things.length <= MOST_HANDLES).slice(0, MOST_HANDLES);
        while (handles.children.length < shown.length)
            handles.append(newHandle());
        while (handles.children.length > shown.length)
            handles.lastChild.remove();
        shown.forEach((thing, i) => {
            const each = handles.children[i], at = things.filter(({ kind }) => kind === thing.kind).indexOf(thing);
            const { across, down, ahead } = view.view ? seen(view.view, thing.at) : { ahead: 0 };
            each.thing = thing;
            each.dataset.kind = thing.kind;
            each.hidden = !(ahead > 0);
            // What is outside stays at the edge, where it can be taken.
            each.style.left = `${100 * Math.max(0.03, Math.min(0.97, 0.5 + across))}%`;
            each.style.top = `${100 * Math.max(0.04, Math.min(0.96, 0.5 + down * canvas.width / canvas.height))}%`;
            const words = thing.kind === "l" ? `light ${at + 1}` : `sphere ${String.fromCharCode(65 + at)}`;
            each.setAttribute("aria-label", `${words} at ${thing.at.join(", ")}. Drag it, or use the arrow keys, plus and minus`);
        });
    }
    const put = (thing, start, ...by) => show(withThing(text, thing.line, moved(view.view, start, ...by)), { keepsView: true });
    function newHandle() {
        const made = element("button", { type: "button", class: "handle" });
        made.addEventListener("pointerdown", (event) => {
            event.preventDefault();
            made.focus({ preventScroll: true });
            made.setPointerCapture(event.pointerId);
            from = { x: event.clientX, y: event.clientY, at: made.thing.at };
        });
        made.addEventListener("pointermove", ({ clientX, clientY, shiftKey }) => {
            if (!from)
                return;
            const across = (clientX - from.x) / canvas.clientWidth, down = (clientY - from.y) / canvas.clientWidth;
            put(made.thing, from.at, ...shiftKey ? [0, 0, down] : [across, down]);
        });
        for (const end of ["pointerup", "pointercancel"])
            made.addEventListener(end, () => { from = null; });
        made.addEventListener("keydown", (event) => {
            const way = KEYS[event.key];
            if (!way || event.ctrlKey || event.metaKey || event.altKey)
                return;
            event.preventDefault();
            put(made.thing, made.thing.at, ...way.map((each) => A_KEY * each));
        });
        return made;
    }

    // ---- the story of a pixel ----------------------------------------------------------------------

    async function explain(chosen = pixel) {
        if (!chosen)
            return;
        pixel = chosen;
        pixelInput.value = `${pixel.column},${pixel.row}`;
        mark.style.left = `${100 * (pixel.column + 0.5) / canvas.width}%`;
        mark.style.top = `${100 * (pixel.row + 0.5) / canvas.height}%`;
        mark.hidden = home !== null;
        try {
            const told = storyOf(await view.pool.explain(view.opened, { ...view.pass(1), view: numbersOf(home ?? view.view) }, pixel), chapterOf);
            story.replaceChildren(...told.lines);
            ({ segments } = told);
            placeHandles();
        } catch (reason) {
            if (reason.message)
                story.replaceChildren(element("p", {}, `There is no story: ${reason.message}.`));
        }
        story.hidden = turn.hidden = false;
    }
    function setHome(other) {
        home = other;
        mark.hidden = home !== null;
        turn.textContent = home ? "From the eye" : "From beside";
    }
    /** From the eye itself a ray is a point: it is seen from elsewhere, and may be turned there. */
    function turnAside() {
        const before = home;
        setHome(before ? null : view.view);
        view.look(before ?? beside(view.view));
    }

    // ---- the page ----------------------------------------------------------------------------------

    scenes.addEventListener("change", () => choose(scenes.value).catch((reason) => tell(reason.message)));
    casters.addEventListener("change", () => { view.caster = casters.value; view.draw(); });
    pixelInput.addEventListener("change", () => {
        const [, column, row] = /^\s*(\d+)\s*,\s*(\d+)\s*$/.exec(pixelInput.value) ?? [];
        if (column < canvas.width && row < canvas.height)
            explain({ column: Number(column), row: Number(row) });
    });
    details.addEventListener("toggle", () => {
        if (!details.open) {
            view.pool.sleep();
            race?.stop();
        } else if (linked !== null) {
            view.draw();
        } else {
            begin().catch((reason) => tell(reason.message));
        }
    });
    async function begin() {
        view.caster = casters.value;
        const given = /^#scene=(.+)/.exec(location.hash), wantedScene = given ? await unpacked(given[1]).catch(() => null) : null;
        await choose(wantedScene?.name in SCENES ? wantedScene.name : FIRST);
        if (wantedScene?.text)
            show(wantedScene.text);
        if (wantedScene?.view)
            view.view = viewOf(wantedScene.view);
        if (given && !wantedScene)
            tell("The link has no scene that can be read.");
        await follow();
    }
    document.querySelector("#reset").after(button("Scene", () => {
        details.open = !details.open;
        if (narrow.matches)
            showView("verdict");
    }));
    // Beside the lesson, or on a phone below the verdict.
    const narrow = matchMedia("(max-width: 61.99rem)"), place = () => document.querySelector(narrow.matches ? ".verdict" : ".lesson").append(details);
    narrow.addEventListener("change", place);
    place();
    const open = () => { details.open = true; };
    document.querySelector("#editor").addEventListener("focusin", open, { once: true });
    if (/^#scene=/.test(location.hash))
        open();
    return { follow };
}
