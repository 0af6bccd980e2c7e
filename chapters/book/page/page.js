// page.js - what every page of the site does: theme, progress over the chapters, figures on the full screen; and what
// each kind of page needs besides that.
import { answersIn, download, openAnswers, writableStorage } from "./answers.js";
import { setUpExercise } from "./exercise.js";
import { setUpFigures } from "./figures.js";
import { Drawer, Helper } from "../worker_questions.js";
import { setUpLetters } from "./letters.js";

/* global COURSE */
const root = document.documentElement;
const { up = "", kind, stem } = root.dataset;
const $ = (id) => document.getElementById(id);

export function showTrouble(words) {
    const place = $("trouble");
    if (place) {
        place.textContent = words;
        place.hidden = words === "";
    }
}

const site = new URL(up || ".", location.href);
const answers = openAnswers({ storage: writableStorage(), folder: site.pathname, onTrouble: showUnsaved });

// ---- answers that the browser does not keep -------------------------------------------------------

let isRefused = false, downloaded = ""; // all texts, when they were downloaded
const allTexts = (course) => JSON.stringify(course.stems.map((each) => answers.text(each)));

/** Another page does not know what this one has, so the download is beside the words. */
function showUnsaved(words) {
    isRefused = words !== "";
    const place = $("unsaved");
    if (!place)
        return;
    place.hidden = words === "";
    if (place.firstElementChild.textContent !== words)
        place.firstElementChild.textContent = words;
}
function setUpDownload(button, course) {
    button?.addEventListener("click", async () => {
        showTrouble("");
        try {
            const count = await download(course.stems, answers);
            downloaded = allTexts(course);
            $("state").textContent = count === 0 ? "There is no answer yet. Begin with a chapter." : `submission.zip has ${count} answer${count === 1 ? "" : "s"}.`;
        } catch (reason) {
            showTrouble(reason.message);
        }
    });
}

// ---- theme --------------------------------------------------------------------------------------

const dark = matchMedia("(prefers-color-scheme: dark)");
export const themeNow = () => root.dataset.theme ?? (dark.matches ? "dark" : "light");

/** Pictures follow the system's theme by themselves; a theme that was chosen here, by other media. */
function themePictures() {
    for (const source of document.querySelectorAll("picture source")) {
        source.dataset.media ??= source.media;
        const isDark = source.dataset.media.includes("dark");
        const rest = source.dataset.media.replace(/(and )?\(prefers-color-scheme: dark\)/, "").trim();
        if (root.dataset.theme === undefined)
            source.media = source.dataset.media;
        else if (isDark)
            source.media = root.dataset.theme === "dark" ? rest || "all" : "not all";
    }
}

function setUpTheme() {
    const button = $("theme");
    const label = () => { button.textContent = themeNow() === "dark" ? "Light" : "Dark"; button.title = `Use the ${button.textContent.toLowerCase()} theme`; };
    button.addEventListener("click", () => {
        const other = themeNow() === "dark" ? "light" : "dark";
        if (other === (dark.matches ? "dark" : "light"))
            delete root.dataset.theme;
        else
            root.dataset.theme = other;
        try {
            if (root.dataset.theme)
                localStorage.setItem("ray-casting theme", other);
            else
                localStorage.removeItem("ray-casting theme");
        } catch {
            // The choice lasts as long as the page.
        }
        changed();
    });
    const changed = () => { label(); themePictures(); document.dispatchEvent(new CustomEvent("theme", { detail: themeNow() })); };
    dark.addEventListener("change", changed);
    changed();
}

// ---- progress -----------------------------------------------------------------------------------

function showProgress(course) {
    let right = 0, total = 0, next = null;
    for (const each of course.stems) {
        const verdict = answers.verdict(each), of = course.functions[each]?.length ?? 0;
        right += verdict?.right ?? 0;
        total += of;
        if (!verdict?.done)
            next ??= each;
        document.querySelector(`.top li[data-stem="${each}"]`)?.style.setProperty("--part", (verdict?.right ?? 0) / of);
        for (const place of document.querySelectorAll(`li[data-stem="${each}"] .done`)) {
            place.textContent = verdict?.done ? "✓ done" : verdict?.right > 0 ? `${verdict.right} of ${of} right`
                : answers.text(each) !== null ? `begun, ${of} function${of === 1 ? "" : "s"}` : `${of} function${of === 1 ? "" : "s"}`;
            place.classList.toggle("right", Boolean(verdict?.done));
        }
    }
    if (kind === "start") {
        $("so-far").textContent = right > 0 ? `${right} of ${total} functions are right.` : "";
        const begun = course.stems.some((each) => answers.text(each) !== null);
        if (next && begun) {
            $("begin").href = `${next}.html`;
            $("begin").textContent = `Continue with chapter ${next.slice(0, 2)}`;
        } else if (!next) {
            $("begin").textContent = "All chapters are done";
        }
    }
}

// ---- the start page -----------------------------------------------------------------------------

/** Judges answers that were not typed here, one after the other, so that the page can count what is right. */
async function judgeAll(stems, course, onNext) {
    const helper = new Helper(() => new Worker(new URL("judge_worker.js", site), { type: "module" }));
    for (const each of stems.filter((one) => answers.verdict(one) === null)) {
        onNext(each);
        const text = answers.text(each), sources = Object.fromEntries(course.stems.map((one) => [one, answers.text(one)]).filter(([, other]) => other !== null));
        try {
            const verdict = await helper.ask({ do: "judge", stem: each, sources, records: {}, isDrawn: false });
            if (answers.text(each) === text) // nothing else was loaded meanwhile
                answers.saveJudged(each, text, verdict);
        } catch {
            // Its own page says why it could not be judged.
        }
        showProgress(course);
    }
    helper.stop("all are judged", false);
}

async function setUpStart(course) {
    const say = (words) => { $("state").textContent = words; };
    let follow = async () => {};
    if (root.dataset.figures !== "static") {
        const { setUpOwnPicture } = await import("./own_picture.js");
        follow = setUpOwnPicture({ place: $("picture"), site, course, answers });
        follow().catch(() => {}); // the picture that the page came with stays
    }
    $("upload").addEventListener("change", async (event) => {
        showTrouble("");
        try {
            const found = await answersIn(event.target.files, course.stems);
            if (found.size === 0)
                throw new Error(`there is no answer in it. Expected a zip archive with ${course.stems[0]}.c and so on, or such files`);
            for (const [each, text] of found) {
                answers.keepVersion(each, "before an upload");
                answers.save(each, text);
            }
            const stems = [...found.keys()].sort(), loaded = `Loaded ${stems.map((each) => each.slice(0, 2)).join(", ")}.`;
            showProgress(course);
            judgeAll(stems, course, (each) => say(`${loaded} Judging ${each.slice(0, 2)}.`)).then(() => {
                say(`${loaded} Open a chapter to see its verdict.`);
                return follow();
            }).catch(() => {});
        } catch (reason) {
            showTrouble(`The upload was not read: ${reason.message}. Nothing has changed.`);
        }
        event.target.value = "";
    });
}

// ---- without a network, and new versions ----------------------------------------------------------

// The service worker is started after the first work is done, so that it does not compete with it: what it
// fetches is ten times what the first verdict needs.
const LATEST = 60_000; // milliseconds, if the work does not end

function keepForOffline() {
    const start = () => navigator.serviceWorker.register(new URL("service_worker.js", site), { scope: site.pathname }).catch(() => {});
    if ($("editor") && !globalThis.judgeIsReady) {
        addEventListener("judge-ready", start, { once: true });
        setTimeout(start, LATEST);
    } else if (document.readyState === "complete")
        setTimeout(start, 1500);
    else
        addEventListener("load", () => setTimeout(start, 1500));
}

// A page that was just opened changes to the new version of the site, if that is there and no other page
// of the site is open: those would load files of two versions.
//
// Nothing else of the page begins before that. A browser waits until the old service worker has nothing to do, and the
// page's Workers would give it work. It may wait for half a minute then, and a student would see the page load again.
const EVERY = 100, MOST = 2000; // milliseconds

async function takeNewVersion() {
    // The first visit ends without a service worker for its page, so this is always another version.
    navigator.serviceWorker.addEventListener("controllerchange", () => location.reload());
    const waiting = (await navigator.serviceWorker.getRegistration())?.waiting;
    if (!waiting)
        return;
    const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
    let takesOver = false;
    navigator.serviceWorker.addEventListener("message", ({ data }) => { takesOver ||= data === "the new version takes over"; });
    navigator.serviceWorker.startMessages();
    // The page before this one may be open for a moment longer, so this asks again.
    for (let waited = 0; waited < MOST && !takesOver; waited += EVERY) {
        waiting.postMessage("take over if one page is open");
        await pause(EVERY);
    }
    if (takesOver)
        await pause(MOST);
}

// ---- start --------------------------------------------------------------------------------------

const keepsPages = "serviceWorker" in navigator && location.protocol !== "file:";
if (keepsPages)
    await takeNewVersion().catch(() => {});
setUpTheme();
const drawer = new Drawer(() => new Worker(new URL("figure_worker.js", site), { type: "module" }));
// The figures are seen first.
const firstFigure = document.querySelector(".figure") && setUpFigures({ site, themeNow, drawer });
const course = COURSE; // written here when the site is built: site/make_pages.mjs
showProgress(course);
setUpDownload($("download"), course);
setUpDownload($("unsaved")?.querySelector("button"), course);
addEventListener("beforeunload", (event) => {
    if (isRefused && allTexts(course) !== downloaded)
        event.preventDefault(); // the browser asks
});
addEventListener("storage", (event) => {
    if (answers.changeIn(event, course.stems))
        showProgress(course);
});
// A page that comes back from the browser's memory shows what happened since.
addEventListener("pageshow", (event) => {
    if (event.persisted)
        showProgress(course);
});

if (kind === "start")
    await setUpStart(course);
if (kind === "mistakes")
    import("./mistakes.js").then(({ setUpMistakes }) => setUpMistakes({ site, course, answers, showTrouble })).catch((reason) => showTrouble(`${reason.message}.`));
if (kind === "chapter") {
    setUpLetters(document.querySelector(".lesson"));
    setUpExercise({ stem, site, course, answers, themeNow, showTrouble, firstFigure, drawer, onVerdict: () => showProgress(course) });
}
globalThis.takeEarlyClicks(); // early.js
if (keepsPages)
    keepForOffline();
