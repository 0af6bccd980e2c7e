// exercise.js - the exercise of a chapter: the editor, and everything around it. The work is done in a Worker
// (judge_worker.js), so the page always answers.
import { Helper, Stopped } from "../worker_questions.js";
import { selectTab, setUpRoom, setUpTabs, showView } from "./room.js";
import { element, marksOf, shown as shownVerdict, wayOn } from "./verdict.js";

const PAUSE = 600;    // milliseconds without a key, after which an answer is judged
const FIGURE = 4000; // milliseconds, at most, that the editor and the compiler wait for the first figure
const PROGRESS = 400; // milliseconds, after which work shows how far it is
const $ = (id) => document.getElementById(id);
const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
const isMac = /Mac|iPhone|iPad/.test(navigator.userAgentData?.platform ?? navigator.platform);

export function setUpExercise({ stem, site, course, answers, themeNow, showTrouble, firstFigure, drawer, onVerdict }) {
    const still = $("editor").querySelector("pre"), blank = still.textContent;
    const helper = new Helper(() => new Worker(new URL("judge_worker.js", site), { type: "module" }));
    const say = (words) => { $("state").textContent = words; };
    const saved = () => answers.isKept(stem) ? "Your answer is saved." : "Your answer is not saved.";
    setUpRoom();
    $("judge-keys").textContent = isMac ? "⌘ ⏎" : "Ctrl Enter";

    // ---- saving ----------------------------------------------------------------------------------

    let timer, marked = [];
    // Until the editor is there, the page shows the text.
    /** @type {Partial<ReturnType<typeof import("./editor.js").openEditor>>} */
    let editor = {
        text: () => still.textContent,
        replace(text) { still.textContent = text; },
        mark(marks) { marked = marks; },
        focus() { still.focus(); },
        goTo() { still.focus(); },
    };
    if (answers.text(stem) !== null)
        editor.replace(answers.text(stem));
    const ofEditor = {
        place: $("editor"), contract: $("panel-contract").textContent,
        label: `Your answer, ${stem}.c. Escape and then Tab leaves the editor.`,
        onJudge: () => judge(),
        onChange(text) {
            if (answers.text(stem) === null)
                navigator.storage?.persist?.().catch(() => {}); // asks the browser not to throw answers away
            say(answers.save(stem, text) ? "Saved." : "Not saved.");
            showUndo();
            $("verdict").classList.toggle("old", text !== judged);
            clearTimeout(timer);
            timer = setTimeout(() => judge(), PAUSE);
        },
    };
    /** The editor is large: it is fetched after the first figure, or at once for a student who wants to type. */
    async function prepareEditor() {
        await Promise.race([firstFigure?.shown, pause(FIGURE), ...["focus", "pointerdown"].map((kind) => new Promise((resolve) => still.addEventListener(kind, resolve)))]);
        const { openEditor } = await import("./editor.js");
        const wasChosen = document.activeElement === still;
        editor = openEditor({ ...ofEditor, text: editor.text() });
        editor.mark(marked);
        if (wasChosen)
            editor.focus();
    }
    prepareEditor().catch((reason) => showTrouble(`The editor could not be fetched: ${reason.message}. Load the page again.`));
    const showUndo = () => { $("undo-reset").hidden = !(editor.text() === blank && answers.versions(stem).length > 0); };
    showUndo();
    if (answers.text(stem) !== null)
        say("Your saved answer.");

    $("reset").addEventListener("click", () => {
        answers.keepVersion(stem, "before a reset");
        editor.replace(blank);
        answers.save(stem, blank);
        say("The exercise is as at the beginning. Your answer is kept: you can undo this.");
        showUndo();
        judge();
    });
    $("undo-reset").addEventListener("click", () => {
        const version = answers.takeVersion(stem);
        if (version === null)
            return;
        editor.replace(version.text);
        answers.save(stem, version.text);
        say("Your answer is back.");
        showUndo();
        judge();
        editor.focus();
    });
    // The same chapter in another tab: both show the same text.
    addEventListener("storage", (event) => {
        if (answers.changeIn(event, [stem])?.what !== "answer" || event.newValue === null || event.newValue === editor.text())
            return;
        editor.replace(event.newValue);
        $("verdict").classList.add("old");
        say("Changed in another tab.");
        showUndo();
    });

    // ---- files -----------------------------------------------------------------------------------

    const tabs = [$("tab-answer"), $("tab-contract")];
    function choose(chosen) {
        selectTab(tabs, chosen);
        for (const tab of tabs)
            $(tab.getAttribute("aria-controls")).hidden = tab !== chosen;
    }
    setUpTabs(tabs, choose);

    // ---- judging ---------------------------------------------------------------------------------

    let judged = null, shown = null, running = false, again = false, subject = "";
    let drawn = []; // the figures and pictures in the page
    const isSame = (a, b) => a.length === b.length && a.every((byte, at) => byte === b[at]);

    function showProgress({ words, done, all }) {
        $("progress-words").textContent = all > 0 ? `${words}, ${(done / 1e6).toFixed(1)} of ${(all / 1e6).toFixed(1)} MB` : words;
        $("bar").hidden = all === 0; // without an end it would move, and drawing that takes time from the judge
        $("bar").value = all > 0 ? done / all : 0;
    }

    /** The texts of all chapters: the program of a chapter calls the answers of earlier ones. */
    const sources = () => Object.fromEntries(course.stems.map((each) => [each, each === stem ? editor.text() : answers.text(each)]).filter(([, text]) => text !== null));

    /** What the judge found in other chapters, if their text is still the same. */
    const records = () => Object.fromEntries(course.stems.filter((each) => each !== stem && answers.verdict(each)).map((each) => [each, answers.note(each, "record")])
        .filter(([, record]) => record));

    /** The figures and pictures of the verdict that is shown. One that the page has already stays: an image takes memory for a while. */
    async function drawPictures() {
        const verdict = shown, place = $("verdict-pictures"), theme = themeNow(), before = drawn;
        const wanted = await Promise.all([
            ...verdict.scripts.map(async (script) => {
                const is = (other) => other.script === script && other.theme === theme;
                return before.find(is) ?? { script, theme, type: "image/svg+xml", caption: "Yours beside the expected one.", ...await drawFigure(script, theme) };
            }),
            ...verdict.pictures.map(({ bytes, words }) =>
                before.find((other) => other.caption === words && !other.script && isSame(other.bytes, bytes)) ?? { bytes, words: "The picture that your code draws", caption: words, type: "image/png" })]);
        if (verdict !== shown || theme !== themeNow())
            return;
        for (const old of drawn.filter((each) => !wanted.includes(each))) {
            const img = old.figure.querySelector("img");
            URL.revokeObjectURL(img.src);
            img.removeAttribute("src"); // it takes no memory until the element is collected
        }
        for (const each of wanted)
            each.figure ??= pictured(each);
        drawn = wanted;
        place.replaceChildren(...wanted.map(({ figure }) => figure));
    }
    async function drawFigure(script, theme) {
        const { svg, words } = await drawer.ask({ do: "script", script, theme, shape: "4:3" }); // its place is narrow
        return { bytes: svg, words };
    }
    function pictured({ bytes, type, words, caption }) {
        const src = URL.createObjectURL(new Blob([bytes], { type }));
        const larger = element("a", { href: src, target: "_blank", title: "Larger, in another tab" }, element("img", { src, alt: words }));
        return element("figure", {}, larger, ...caption ? [element("figcaption", {}, caption)] : []);
    }

    function show(verdict, text) {
        judged = text;
        const { strip, first, details } = shownVerdict(verdict, stem, text, (line) => { showView("code"); choose(tabs[0]); editor.goTo(line); });
        const isNews = $("first").textContent !== first.map((each) => each.textContent ?? each).join("");
        $("strip").replaceChildren(...strip);
        if (isNews) {
            $("first").replaceChildren(...first); // read aloud
            $("verdict").scrollTop = 0; // on a wide screen it scrolls by itself
        }
        $("details").replaceChildren(...details);
        $("verdict").dataset.result = verdict.done ? "right" : "wrong";
        $("verdict").classList.toggle("old", editor.text() !== judged);
        editor.mark(marksOf(verdict, stem, text));
        $("way-on").replaceChildren(...(verdict.done ? wayOn(stem, course) : []));
        const about = verdict.parts.find(({ kind }) => kind === "function")?.label ?? "";
        if (about !== subject && verdict.total > 0) {
            $("hints").replaceChildren(); // their function is done with
            subject = about;
        }
        $("hint").hidden = verdict.done;
        shown = verdict;
        drawPictures().catch((reason) => showTrouble(`The figure of the verdict could not be drawn: ${reason.message}.`));
        answers.saveJudged(stem, text, verdict);
        if (verdict.total > 0)
            live?.follow();
        onVerdict();
    }

    async function judge() {
        clearTimeout(timer);
        if (running) {
            again = true;
            return;
        }
        running = true;
        const text = editor.text(), start = performance.now();
        // What was not changed is not saved; what is judged is.
        if (answers.text(stem) === null)
            answers.save(stem, text);
        const late = setTimeout(() => { $("progress").hidden = false; }, PROGRESS);
        showProgress({ words: "Judging", done: 0, all: 0 });
        try {
            showTrouble("");
            const question = { do: "judge", stem, sources: sources(), records: records() };
            let took = 0;
            const hear = (progress) => {
                if (progress.first) {
                    took = performance.now() - start;
                    show(progress.first, text);
                }
                showProgress(progress);
            };
            const verdict = await helper.ask(question, hear).catch((reason) => {
                if (reason instanceof Stopped && !reason.isBusy)
                    return helper.ask(question, hear); // once more, in a new Worker
                throw reason;
            });
            show(verdict, text);
            say(`${answers.isKept(stem) ? "Saved and judged" : "Judged, not saved"}, ${Math.round(took || performance.now() - start)} ms.`);
        } catch (reason) {
            showTrouble(reason instanceof Stopped
                ? `The judge was ended and starts again, because ${reason.message}. ${saved()} Change it, or press Judge to try again.`
                : `This could not be judged: ${reason.message}. ${saved()} Press Judge to try again.`);
            if (reason instanceof Stopped)
                getReady().catch(() => {});
        }
        clearTimeout(late);
        $("progress").hidden = true;
        running = false;
        if (again) {
            again = false;
            if (editor.text() !== judged)
                judge();
        }
    }

    $("judge").addEventListener("click", () => judge());
    addEventListener("keydown", (event) => {
        if (event.key === "Enter" && (event.ctrlKey || event.metaKey) && !event.defaultPrevented) {
            event.preventDefault();
            judge();
        }
    });

    // ---- a scene, from the chapter on that makes rays: not in a handout's site, which has no reference -----------------

    let live = null;
    if (stem >= "04" && document.documentElement.dataset.figures !== "static")
        import("./live_scene.js").then(({ setUpLiveScene }) => { live = setUpLiveScene({ stem, site, course, answers, ask: (what) => helper.ask(what, showProgress) }); })
            .catch(reportError); // the exercise goes on without it

    // ---- hints -----------------------------------------------------------------------------------

    $("hint").addEventListener("click", async () => {
        try {
            showTrouble("");
            const known = [...$("hints").children];
            let next, isKnown = true;
            for (let asked = 0; isKnown && asked <= known.length; asked++) { // after a change the judge begins again
                const { parts, state } = await helper.ask({ do: "hint", stem, sources: sources(), state: answers.note(stem, "hint") ?? "" }, showProgress);
                answers.saveNote(stem, "hint", state);
                next = element("li", {}, element("h4", {}, parts[0].label), element("p", {}, parts[0].words.trim()));
                isKnown = known.some((each) => each.textContent === next.textContent);
            }
            if (!isKnown)
                $("hints").append(next);
            $("hints").lastElementChild.scrollIntoView({ block: "nearest" });
        } catch (reason) {
            showTrouble(`There is no hint now: ${reason.message}.`);
        }
    });

    // ---- the judge is made ready while the student reads -----------------------------------------

    /** Fetches and starts what a verdict needs. */
    const getReady = () => helper.ask({ do: "prepare", stem, text: blank });

    /** The compiler is ten times as large as a figure, which is seen first: it is fetched while that is drawn. */
    async function begin() {
        await Promise.race([firstFigure?.fetched, pause(FIGURE)]);
        if (answers.text(stem) !== null && judged === null)
            await judge();
        await getReady();
        globalThis.judgeIsReady = true;
        dispatchEvent(new Event("judge-ready")); // page.js
    }
    if (!navigator.connection?.saveData)
        begin().catch(() => {}); // the student is told when an answer is judged
    document.addEventListener("theme", () => {
        if (shown)
            drawPictures().catch(() => {});
    });
}
