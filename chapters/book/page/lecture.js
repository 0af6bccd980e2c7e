// lecture.js - the lecture on a screen: page after page of its slides, with figures that can be dragged; a window for the
// speaker, an overview, a pen. One classic script, so the page also works as a file, without a server; then its figures
// are static, because a browser starts no Worker there.
import { liveFigure } from "./figures.js";
import { element, shown } from "./verdict.js";
import { Drawer, Helper } from "../worker_questions.js";

const WIDTH = 960, HEIGHT = 540; // of a slide
const WORDS_WIDTHS = [324, 342, 360, 384, 420, 480, 540]; // of the words beside a figure, until they are not too high
const $ = (id) => document.getElementById(id);
const root = document.documentElement, stage = $("stage"), pages = [...stage.children];
const isSpeaker = new URLSearchParams(location.search).has("speaker");
const dark = matchMedia("(prefers-color-scheme: dark)");
const themeNow = () => root.dataset.theme ?? (dark.matches ? "dark" : "light");
let at = 0, other = isSpeaker ? opener : null; // the other window
const began = Date.now();

// ---- which page is shown ----------------------------------------------------------------------------

const indexOf = (address) => Math.max(0, pages.findIndex((page) => page.id === address));

function show(index, { tell = true } = {}) {
    at = Math.max(0, Math.min(pages.length - 1, index));
    const page = pages[at];
    pages.forEach((each, i) => {
        each.classList.toggle("shown", i === at);
        each.classList.toggle("following", isSpeaker && i === at + 1);
        each.inert = i !== at;
    });
    root.classList.remove("large-code");
    history.replaceState(null, "", `#${page.id}`);
    document.title = `${page.querySelector("h1, h2").textContent} · Lecture`;
    $("spoken").textContent = page.getAttribute("aria-label");
    document.querySelector("[data-do=film]").hidden = !page.dataset.film;
    makeLive(page);
    drawStrokes();
    showNotes(page);
    if (tell)
        other?.postMessage({ lecture: page.id }, "*");
}

addEventListener("hashchange", () => show(indexOf(decodeURIComponent(location.hash.slice(1)))));
addEventListener("message", ({ data, source }) => {
    if (typeof data?.lecture !== "string")
        return;
    other = source;
    if (data.lecture === "")
        source.postMessage({ lecture: pages[at].id }, { targetOrigin: "*" });
    else
        show(indexOf(data.lecture), { tell: false });
});

// ---- sizes ----------------------------------------------------------------------------------------------

function resize() {
    stage.style.setProperty("--scale", Math.min(innerWidth / WIDTH, innerHeight / HEIGHT));
    const pen = $("pen"), box = pages[at].getBoundingClientRect();
    Object.assign(pen.style, { left: `${box.left}px`, top: `${box.top}px` });
    [pen.width, pen.height] = [box.width, box.height];
    drawStrokes();
}

/** The words beside a figure take more of the width if they are too high, and a figure below words is as wide as there is room
 * for its height. All pages of a slide have the same. */
function fitWords() {
    for (const page of pages) {
        const { clientHeight: room } = page.querySelector(".body"), words = page.querySelector(".words");
        if (page.matches(".full") && words.scrollHeight > room)
            page.style.setProperty("--size", "26px");
        if (page.matches(".below") && page.querySelector(".figure"))
            page.style.setProperty("--widest", `${page.querySelector(".figure").clientHeight * 960 / 464}px`);
        if (page.dataset.page !== "1" || !page.classList.contains("beside"))
            continue;
        const width = WORDS_WIDTHS.find((each) => {
            page.style.setProperty("--words", `${each}px`);
            return words.scrollHeight <= room && words.scrollWidth <= words.clientWidth;
        });
        for (const each of pages.filter((one) => one.dataset.name === page.dataset.name))
            each.style.setProperty("--words", `${width ?? WORDS_WIDTHS.at(-1)}px`);
    }
}

// ---- figures --------------------------------------------------------------------------------------------

const live = new Map(); // by the slide's name: its figure, which goes from page to page
let drawer = null;

function worker() {
    if (location.protocol === "file:" || root.dataset.figures === "static")
        return null;
    drawer ??= new Drawer(() => new Worker(new URL("figure_worker.js", location.href), { type: "module" }));
    return drawer;
}

/** The figure of a page can be dragged: what was dragged stays on the slide's other pages. */
function makeLive(page) {
    const figure = page.querySelector(".figure");
    document.querySelector("[data-do=numbers]").hidden = !figure || !worker();
    if (!figure || isSpeaker || !worker())
        return;
    const { name } = page.dataset, step = Number(figure.dataset.step);
    const known = live.get(name);
    if (known === undefined) {
        const moving = figure.cloneNode(true);
        live.set(name, { figure: moving, control: null, home: null });
        place(live.get(name), figure);
        live.get(name).control = liveFigure(moving, { ask: (what) => drawer.ask(what), themeNow, shape: moving.dataset.shape });
    } else {
        if (known.figure !== figure)
            place(known, figure);
        known.control.goTo(step);
    }
}

/** Puts a live figure in the place of a page's static one, and that of the page before back. */
function place(moving, figure) {
    if (moving.home)
        moving.figure.replaceWith(moving.home);
    moving.home = figure;
    figure.replaceWith(moving.figure);
}

function theme() {
    const name = themeNow() === "dark" ? "light" : "dark";
    root.dataset.theme = name;
    pictures();
    document.dispatchEvent(new Event("theme"));
}

function pictures() {
    for (const image of stage.querySelectorAll(".figure img")) {
        image.dataset.light ??= image.getAttribute("src");
        image.src = themeNow() === "dark" ? image.dataset.light.replace(".svg", "-dark.svg") : image.dataset.light;
    }
}

// ---- the pen --------------------------------------------------------------------------------------------

const strokes = new Map(); // by the page: lines of points, in units of a slide

function drawStrokes() {
    const pen = $("pen"), context = pen.getContext("2d");
    context.clearRect(0, 0, pen.width, pen.height);
    context.lineWidth = 4 * pen.width / WIDTH;
    context.lineCap = context.lineJoin = "round";
    context.strokeStyle = "#d6336c";
    for (const line of strokes.get(pages[at].id) ?? []) {
        context.beginPath();
        line.forEach(([x, y]) => context.lineTo(x * pen.width / WIDTH, y * pen.height / HEIGHT));
        context.stroke();
    }
}

function setUpPen() {
    const pen = $("pen");
    const point = (event) => [event.offsetX * WIDTH / pen.clientWidth, event.offsetY * HEIGHT / pen.clientHeight];
    pen.addEventListener("pointerdown", (event) => {
        pen.setPointerCapture(event.pointerId);
        const page = pages[at].id;
        strokes.set(page, [...(strokes.get(page) ?? []), [point(event)]]);
    });
    pen.addEventListener("pointermove", (event) => {
        if (pen.hasPointerCapture(event.pointerId)) {
            strokes.get(pages[at].id).at(-1).push(point(event));
            drawStrokes();
        }
    });
}

// ---- a student's line -----------------------------------------------------------------------------------

let judge = null, blanks = null; // by stem

/** A blank in which a function has these words: a whole function, lines of its body, or what it returns. */
function answerWith(blank, name, words) {
    const [whole, type] = new RegExp(`^(\\w+) \\*?${name}\\([^]*?\\n}\\n`, "m").exec(blank);
    const isWhole = new RegExp(`\\b${name}\\s*\\([^;]*\\{`).test(words), isBody = words.includes(";");
    const body = isBody ? words : `return ${words.startsWith("{") ? `(${type})` : ""}${words};`;
    return blank.replace(whole, () => isWhole ? `${words}\n` : `${whole.slice(0, whole.indexOf("{"))}{\n${body}\n}\n`);
}

/** The functions that can be judged; first those that the slide's lower edge names. */
async function openLine() {
    $("line").showModal();
    blanks ??= Object.fromEntries(Object.entries(await (await fetch("tree/files.json")).json())
        .flatMap(([path, text]) => (path.startsWith("build/blanks/") ? [[path.slice(13, -2), text]] : [])));
    const all = Object.entries(blanks).flatMap(([stem, text]) => [...text.matchAll(/^(\w+ \*?(\w+)\([^;]*?\))\n\{/mg)].map(([, head, name]) => new Option(head.replace(/\s+/g, " "), `${stem}/${name}`)));
    const named = pages[at].querySelector("footer").textContent, isNamed = ({ value }) => Number(new RegExp(`\\b${value.split("/")[1]}\\b`).test(named));
    $("line").querySelector("select").replaceChildren(...all.sort((a, b) => isNamed(b) - isNamed(a)));
    $("line").querySelector("textarea").focus();
    judge ??= new Helper(() => new Worker(new URL("judge_worker.js", location.href), { type: "module" }));
    const [stem] = Object.keys(blanks);
    await judge.ask({ do: "prepare", stem, text: blanks[stem] }); // the compiler, while something is typed
}

async function judgeLine() {
    const [stem, name] = $("line").querySelector("select").value.split("/"), said = $("line").querySelector("output");
    const words = $("line").querySelector("textarea").value.trim(), sources = { [stem]: answerWith(blanks[stem], name, words) };
    const tell = (...parts) => said.replaceChildren(...parts);
    const show = ({ progress, scripts, pictures: drawn, ...verdict }) => {
        const state = verdict.states[name], { first: [cause], details } = shown(verdict, stem, "", () => {});
        const result = state === "right" ? "✓ Right." : state === "wrong" ? `✗ ${cause}` : `✗ Not judged. ${cause}`;
        tell(Object.assign(document.createElement("p"), { textContent: result }), ...details.filter(({ localName }) => localName === "table" && state === "wrong"));
        const image = (bytes, type) => Object.assign(new Image(), { src: URL.createObjectURL(new Blob([bytes], { type })), alt: "What it draws" });
        if (!progress && scripts[0])
            drawer.ask({ do: "script", script: scripts[0], theme: themeNow() }).then(({ svg }) => said.prepend(image(svg, "image/svg+xml")), () => {});
        else if (drawn[0])
            said.prepend(image(drawn[0].bytes, "image/png"));
    };
    await judge.ask({ do: "judge", stem, sources, records: {} }, ({ words: doing, first }) => (first ? show({ ...first, progress: true }) : tell(`${doing} …`)))
        .then(show, (reason) => tell(`It could not be judged: ${reason.message}.`));
}

// ---- for the speaker ------------------------------------------------------------------------------------

function showNotes(page) {
    if (!isSpeaker)
        return;
    const first = pages.find((each) => each.dataset.name === page.dataset.name);
    $("notes").innerHTML = first.querySelector(".notes").innerHTML;
    const before = pages.slice(0, pages.indexOf(first) + 1).filter((each) => each.dataset.page === "1");
    const until = before.reduce((sum, each) => sum + Number(each.dataset.minutes), 0);
    $("planned").textContent = `${page.dataset.minutes} min for this slide, which ends at ${until} min`;
    const next = pages[at + 1];
    $("following").textContent = !next ? "The end" : next.dataset.name === page.dataset.name ? `Next: step ${next.dataset.page} of ${next.dataset.pages}` :
        `Next: ${next.querySelector("h1, h2").textContent}`;
}

function setUpSpeaker() {
    root.classList.add("for-speaker");
    $("speaker").hidden = false;
    const tick = () => {
        const seconds = Math.floor((Date.now() - began) / 1000);
        $("clock").textContent = `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, "0")}`;
    };
    tick();
    setInterval(tick, 1000);
    other?.postMessage({ lecture: "" }, "*");
}

// ---- what a lecturer does -------------------------------------------------------------------------------

const toggle = (name) => root.classList.toggle(name);
const actions = {
    next: () => show(at + 1),
    back: () => show(at - 1),
    first: () => show(0),
    last: () => show(pages.length - 1),
    full: () => (document.fullscreenElement ? document.exitFullscreen() : root.requestFullscreen?.())?.catch(() => {}),
    speaker: () => { other = open(`?speaker${location.hash}`, "speaker", "width=1200,height=760") ?? other; },
    black: () => { $("black").hidden = !$("black").hidden; },
    overview: () => {
        if (toggle("overview"))
            pages[at].scrollIntoView({ block: "center" });
        else
            resize();
    },
    jump: () => { $("jump").querySelector("input").value = ""; $("jump").showModal(); },
    pen: () => { $("pen").hidden = !$("pen").hidden; resize(); },
    clear: () => { strokes.delete(pages[at].id); drawStrokes(); },
    numbers: () => toggle("typing") && root.querySelector(".shown .figure input")?.focus(),
    code: () => pages[at].querySelector(".qr") && toggle("large-code"),
    film: () => {
        const { film } = pages[at].dataset, video = $("film").querySelector("video");
        if (!film)
            return;
        video.src = `films/${film}${themeNow() === "dark" ? "-dark" : ""}.mp4`;
        $("film").showModal();
        video.play().catch(() => {});
    },
    line: () => worker() && openLine().catch(() => {}),
    theme,
    help: () => $("help").showModal(),
};
const KEYS = {
    ArrowRight: "next", ArrowDown: "next", PageDown: "next", " ": "next", Enter: "next", ArrowLeft: "back", ArrowUp: "back", PageUp: "back", Backspace: "back",
    Home: "first", End: "last", f: "full", F5: "full", s: "speaker", o: "overview", g: "jump", b: "black", ".": "black", d: "pen", c: "clear", n: "numbers", v: "film",
    t: "theme", p: "line", q: "code", "?": "help",
};

function setUpKeys() {
    addEventListener("keydown", (event) => {
        const isTyping = event.composedPath()[0].matches?.("input, video, a, button:not(.handle)") && ![..."gsobdcvtpq?", "PageDown", "PageUp"].includes(event.key);
        const name = KEYS[event.key] ?? KEYS[event.key.toLowerCase()];
        if (event.key === "Escape" && root.classList.contains("overview"))
            actions.overview();
        if (!name || event.ctrlKey || event.metaKey || event.altKey || document.querySelector("dialog[open]") || isTyping ||
            event.composedPath()[0].localName === "input")
            return;
        event.preventDefault();
        if ($("black").hidden || name === "black")
            actions[name]();
        else
            actions.black();
    });
    for (const button of document.querySelectorAll("[data-do]")) {
        button.addEventListener("click", () => {
            actions[button.dataset.do]();
            button.blur(); // so that the next key is for the slides
        });
    }
    $("black").addEventListener("click", actions.black);
    $("judge-line").addEventListener("click", judgeLine);
    $("line").addEventListener("keydown", (event) => event.key === "Enter" && (event.ctrlKey || event.metaKey) && judgeLine());
    $("film").addEventListener("close", () => $("film").querySelector("video").pause());
    $("names").append(...pages.filter((page) => page.dataset.page === "1").map((page) =>
        element("option", { value: page.dataset.name, label: `${page.dataset.slide} ${page.getAttribute("aria-label")}` })));
    $("jump").addEventListener("close", () => {
        const wanted = $("jump").querySelector("input").value.trim().toLowerCase();
        const found = pages.findIndex((page) => page.dataset.slide === wanted || (wanted !== "" && page.id.startsWith(wanted)));
        if (found >= 0)
            show(found);
    });
}

/** A finger goes on by a swipe; in the overview a click chooses a slide. */
function setUpTouch() {
    let down = null;
    stage.addEventListener("pointerdown", (event) => {
        down = event.pointerType === "touch" && !event.composedPath().some((each) => each.localName === "button") ? { x: event.clientX, y: event.clientY } : null;
    });
    stage.addEventListener("pointerup", (event) => {
        const far = down ? event.clientX - down.x : 0;
        if (Math.abs(far) > 40 && Math.abs(far) > 2 * Math.abs(event.clientY - down.y))
            show(at + (far < 0 ? 1 : -1));
        down = null;
    });
    stage.addEventListener("click", (event) => {
        const page = event.target.closest(".slide");
        if (!root.classList.contains("overview") || !page)
            return;
        actions.overview();
        show(indexOf(page.dataset.name));
    });
}

setUpKeys();
setUpTouch();
setUpPen();
if (isSpeaker)
    setUpSpeaker();
pictures();
dark.addEventListener("change", pictures);
addEventListener("resize", resize);
resize();
show(indexOf(decodeURIComponent(location.hash.slice(1))));
document.fonts.ready.then(() => { fitWords(); root.classList.add("ready"); });
