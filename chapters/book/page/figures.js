// figures.js - the figures of a page: live in the place of the static ones, and on the full screen.
import { numbersFollow } from "./numbers.js";

/** The wide SVG of a static figure in a theme. A chart has one for both. */
const fileOf = (site, figure, theme) =>
    new URL(figure.dataset.src.replace(/\.svg$/, theme === "dark" && figure.querySelector("source") ? "-dark$&" : "$&"), site);

/** In the site of a handout, whose programs would hold answers. */
const areStatic = document.documentElement.dataset.figures === "static";

/**
 * @param {{site: URL, themeNow: () => string, drawer: import("../worker_questions.js").Drawer}} given drawer: figure_worker.js
 * @returns {{fetched: Promise<void>, shown: Promise<void>}} of the figures that are in sight at first: what they need is
 *          there; one of them is live. Both end also if there is none, or if it cannot be drawn.
 */
export function setUpFigures({ site, themeNow, drawer }) {
    const figures = [...document.querySelectorAll(".figure")];
    const controls = new Map(); // of the figures that are live
    /** @type {(figure: any) => object} */
    let live = () => null;
    const view = fullScreenView({ site, themeNow, figures, live: (figure) => live(figure) });
    for (const figure of figures) {
        const button = Object.assign(document.createElement("button"), { type: "button", textContent: "Full screen" });
        button.addEventListener("click", () => view.open(figure, button));
        figure.querySelector("figcaption").append(button);
    }
    if (areStatic)
        return { fetched: Promise.resolve(), shown: Promise.resolve() };
    const first = {}, fetched = new Promise((resolve) => { first.fetched = resolve; }), shown = new Promise((resolve) => { first.shown = resolve; });
    const atFirst = (what) => {
        const answer = drawer.ask(what, first.fetched);
        answer.catch(() => {}).then(() => { first.fetched(); first.shown(); });
        return answer;
    };
    const follow = numbersFollow({ stem: document.documentElement.dataset.stem, ask: (what) => drawer.ask(what) });
    live = (figure) => {
        if (!controls.has(figure))
            controls.set(figure, liveFigure(figure, { ask: atFirst, themeNow, onDrawn: follow(figure) }));
        return controls.get(figure);
    };
    // A figure becomes live when it is nearly in sight, and after the page is there.
    const seen = new IntersectionObserver((entries) => {
        const near = entries.filter((each) => each.isIntersecting);
        for (const { target } of near) {
            seen.unobserve(target);
            live(target);
        }
        if (near.length === 0) {
            first.fetched();
            first.shown();
        }
    }, { rootMargin: "300px" });
    figures.forEach((figure) => seen.observe(figure));
    return { fetched, shown };
}

// ---- the full screen: the arrow keys go through the steps of a figure, and on to the next one ----

function fullScreenView({ site, themeNow, figures, live }) {
    const dialog = document.createElement("dialog");
    dialog.className = "full";
    dialog.setAttribute("aria-label", "Figure on the full screen");
    dialog.innerHTML = `<div class="stage"></div><div class="bar"><p role="status"></p>
<button type="button" data-go="-1">Back</button><button type="button" data-go="1" class="main">Next</button><button type="button" data-close>Close</button></div>`;
    document.body.append(dialog);
    const stage = dialog.querySelector(".stage"), status = dialog.querySelector("[role=status]"), home = document.createComment("");
    let at = 0, step = 0, steps = 1, opener = null;

    /** The figure itself is there, so it can be dragged, and keeps its numbers; home marks its place in the page. */
    function giveBack() {
        home.replaceWith(...stage.children);
        stage.replaceChildren();
    }

    function show() {
        const figure = figures[at], control = live(figure), drawing = figure.querySelector(".drawing"), place = `(figure ${at + 1} of ${figures.length})`;
        if (drawing) {
            giveBack();
            drawing.replaceWith(home);
            stage.append(drawing);
        }
        if (control) {
            control.goTo(step || 1000, (drawn) => {
                steps = drawn?.steps ?? 1;
                step = Math.min(step || steps, steps);
                status.textContent = `${drawn?.title ?? ""}${steps > 1 ? `, step ${step} of ${steps}` : ""} ${place}`;
            });
        } else { // without programs, the committed picture
            stage.querySelector("img").src = fileOf(site, figure, themeNow());
            steps = step = 1;
            status.textContent = place;
        }
    }

    function go(by) {
        if (step + by >= 1 && step + by <= steps) {
            step += by;
        } else if (at + by >= 0 && at + by < figures.length) {
            at += by;
            // Forward begins with the first step; backward with the last, 0.
            step = by > 0 ? 1 : 0;
        } else {
            return;
        }
        show();
    }

    dialog.addEventListener("click", ({ target }) => {
        if (target.dataset.go)
            go(Number(target.dataset.go));
        else if ("close" in target.dataset)
            dialog.close();
    });
    dialog.addEventListener("keydown", (event) => {
        if (event.composedPath()[0].localName === "input")
            return;
        // Presenters send PageUp and PageDown.
        const by = { ArrowRight: 1, ArrowDown: 1, PageDown: 1, ArrowLeft: -1, ArrowUp: -1, PageUp: -1 }[event.key] ??
            (event.key === " " && event.target.localName !== "button" ? 1 : 0);
        if (by) {
            event.preventDefault();
            go(by);
        }
    });
    dialog.addEventListener("close", () => {
        if (document.fullscreenElement)
            document.exitFullscreen().catch(() => {});
        giveBack();
        opener?.focus();
    });
    return {
        open(figure, button) {
            at = figures.indexOf(figure);
            step = Number(figure.dataset.step ?? 0) || 0;
            opener = button;
            dialog.showModal();
            dialog.requestFullscreen?.().catch(() => {}); // without it, the figure fills the window
            dialog.querySelector(".main").focus();
            show();
        },
    };
}

// ---- a live figure --------------------------------------------------------------------------------

// A live figure is one that its reader drags, types numbers into, and goes through step by step: by mouse, finger
// or keyboard. The static picture stays until the live one is drawn, and if it cannot be drawn.
//
// Nothing is computed here. The Worker is asked for the figure after a drag; the chapter's program says what can be
// dragged and what follows from it.
const HEIGHT = 540, WIDTHS = { "16:9": 960, "4:3": 720 }; // of the canvas (common/figure/plot.gp)
const NARROW = "(max-width: 600px)";
const A_KEY = 6, A_LARGE_KEY = 48; // how far an arrow key goes, in units of the canvas
const AFTER_A_KEY = 500; // milliseconds until the figure is drawn anew after the last key

const STYLE = `
:host { display: block; }
.canvas { position: relative; touch-action: pan-y; }
.drawing svg { display: block; width: 100%; height: auto; }
.lit { stroke: var(--lit, #ffd9a8); stroke-width: 8px; paint-order: stroke; }
.handle { position: absolute; width: 44px; height: 44px; margin: -22px 0 0 -22px; padding: 0; border: 0; border-radius: 50%;
    background: transparent; cursor: grab; touch-action: none; }
.handle::before { content: ""; position: absolute; inset: 11px; border-radius: 50%; border: 2px solid var(--blue, #0069a8); opacity: 0.45;
    background: color-mix(in srgb, var(--blue, #0069a8) 12%, transparent); }
.handle[hidden] { display: none; }
.handle:hover::before, .handle:focus-visible::before, .handle.held::before { opacity: 1; inset: 8px; }
.handle:focus-visible { outline: 3px solid var(--blue, #0069a8); outline-offset: -4px; }
.handle.held { cursor: grabbing; }
.bar { display: flex; flex-wrap: wrap; align-items: center; gap: 0.4rem 0.9rem; box-sizing: border-box; min-height: 3.7rem; padding: 0.35rem 0.75rem; border-top: 1px solid var(--line, #d0d6dc);
    font: 0.88rem/1.4 var(--sans, sans-serif); color: var(--ink, #1a1c20); background: var(--surface, #f4f6f9); }
.bar button { font: inherit; color: inherit; min-height: 2.1rem; min-width: 2.1rem; padding: 0.15rem 0.6rem; border: 1px solid var(--line, #d0d6dc);
    border-radius: 0.4rem; background: var(--ground, #fff); cursor: pointer; }
.bar button:disabled { opacity: 0.4; cursor: default; }
.bar-fields { display: flex; gap: 0.5rem; flex: 1 1 0; min-width: 0; margin: -4px; padding: 4px; overflow: hidden; white-space: nowrap; }
.bar:not(.folded) .numbers, .folded:not(.open) .bar-fields { display: none; }
.folded .bar-fields { flex: 1 0 100%; flex-wrap: wrap; order: 1; }
.steps { display: flex; align-items: center; gap: 0.4rem; margin-left: auto; }
label { display: flex; flex-direction: column; flex: 1 1 6.2rem; min-width: min-content; max-width: 17rem; font-size: 0.78rem; line-height: 1.2; }
label:has(.short) { flex-basis: 3rem; max-width: 6rem; }
input { font: 0.88rem/1.4 var(--sans, sans-serif); width: 100%; min-width: 5.6rem; min-height: 1.9rem; box-sizing: border-box; padding: 0.1rem 0.3rem; color: inherit;
    background: var(--ground, #fff); border: 1px solid var(--grey, #626a73); border-radius: 0.3rem; }
input.short { min-width: 2.6rem; }
button:focus-visible, input:focus-visible { outline: 3px solid var(--blue, #0069a8); outline-offset: 1px; }
.wrong { flex-basis: 100%; margin: 0; color: var(--orange, #b84a00); }
.wrong:empty { display: none; }
.spoken { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
:host(.on-slide) .canvas { margin-top: var(--cut); }
:host(.on-slide) .steps { display: none; }
:host(.on-slide) .bar { position: absolute; z-index: 1; inset: auto 12px 6px 12px; border: 1px solid var(--line, #d0d6dc); border-radius: 0.4rem; font-size: 18px; visibility: var(--bar, hidden); }
@media (prefers-reduced-motion: no-preference) { .handle::before { transition: inset 0.1s, opacity 0.1s; } }
@media print { .bar, .handles { display: none; } }
@media (forced-colors: active) { .handle::before { border-color: Highlight; opacity: 1; } }
`;

const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

/**
 * While `most` questions are open, of those that follow the newest alone is asked. Answers are taken in the order of the
 * questions; `afterwards` runs when no question is left.
 */
function latest(ask, setBusy) {
    let open = 0, next = null, last = null, before = Promise.resolve();
    function begin() {
        for (let now; (now = next) && open < now.most;) {
            next = null;
            if (open++ === 0)
                setBusy(true);
            const answer = ask(now.what());
            before = Promise.allSettled([before, answer]).then(() => answer).then((drawn) => now.done(drawn, null)).catch((reason) => now.done(null, reason)).then(end);
        }
    }
    function end() {
        open--;
        begin();
        if (open > 0)
            return;
        const then = last;
        last = null;
        setBusy(false);
        then?.();
    }
    return {
        ask(what, done, most = 1) {
            next = { what, done, most };
            begin();
        },
        afterwards(then) {
            if (open > 0)
                last = then;
            else
                then();
        },
    };
}

/**
 * Makes a static figure (site/lesson.mjs) live.
 * @param {HTMLElement} figure with data-stem, data-figure, data-step; its .drawing is filled
 * @param {{ask: (what: object) => Promise<object>, themeNow: () => string, onDrawn?: (drawn: object) => void, shape?: string}} given
 *        onDrawn: after each drawing, with the options and the time that it took; shape: on a slide, whatever the window is
 * @returns {{goTo: (step: number) => void}}
 */
export function liveFigure(figure, { ask, themeNow, onDrawn = () => {}, shape: fixedShape = "" }) {
    const { stem, figure: name } = figure.dataset, place = figure.querySelector(".drawing");
    const narrow = matchMedia(NARROW), questions = latest(ask, (busy) => place.setAttribute("aria-busy", busy || held !== null));
    let step = Number(figure.dataset.step ?? 0) || 1000, steps = 1, options = {}, shown = null, root = null, keys, held = null;
    const elements = {};

    const shape = () => fixedShape || (narrow.matches ? "4:3" : "16:9");
    const wanted = (more = {}) => ({ do: "figure", stem, name, theme: themeNow(), shape: shape(), step, options, ...more });

    /** @param {(drawn: any) => void} [then] */
    function redraw(more, then = () => {}) {
        let began, asked;
        questions.ask(() => { began = performance.now(); return (asked = wanted(more)); }, (drawn, reason) => {
            if (drawn) {
                if (asked.options === options) // nothing was typed since
                    options = drawn.options;
                show({ ...drawn, shape: asked.shape });
                onDrawn({ ...drawn, milliseconds: performance.now() - began });
            } else if (root) {
                elements.wrong.textContent = reason.message;
            }
            then(drawn);
        }, more?.beside ? 2 : 1);
    }

    // ---- what is there ------------------------------------------------------------------------------

    function begin() {
        const host = document.createElement("div");
        host.className = fixedShape && "on-slide";
        root = host.attachShadow({ mode: "open" });
        const sheet = new CSSStyleSheet();
        sheet.replaceSync(STYLE);
        root.adoptedStyleSheets = [sheet];
        root.innerHTML = `<div class="canvas"><div class="drawing"></div><div class="handles"></div></div>
<form class="bar"><button type="button" class="numbers" aria-expanded="false">Numbers</button><span class="fields"></span><button type="button" class="reset" hidden>Reset</button>
<span class="steps"><button type="button" class="back" aria-label="Back one step">‹</button><span class="step"></span><button type="button" class="next" aria-label="Forward one step">›</button></span>
<p class="wrong" role="alert"></p></form><p class="spoken" role="status"></p>`;
        for (const name of ["canvas", "drawing", "handles", "numbers", "fields", "reset", "steps", "back", "step", "next", "wrong", "spoken", "bar"])
            elements[name] = root.querySelector(`.${name}`);
        elements.fields.className = "bar-fields";
        elements.reset.addEventListener("click", () => { options = {}; elements.wrong.textContent = ""; redraw(); });
        elements.numbers.addEventListener("click", () => elements.numbers.setAttribute("aria-expanded", String(elements.bar.classList.toggle("open"))));
        new ResizeObserver(fold).observe(elements.bar);
        elements.back.addEventListener("click", () => go(-1));
        elements.next.addEventListener("click", () => go(1));
        elements.bar.addEventListener("submit", (event) => event.preventDefault());
        place.replaceChildren(host);
        figure.classList.add("live");
    }

    function show(drawn) {
        if (!root)
            begin();
        shown = drawn;
        steps = drawn.steps;
        step = Math.min(step, steps);
        elements.drawing.innerHTML = drawn.svg;
        elements.wrong.textContent = "";
        elements.steps.hidden = steps < 2;
        elements.step.textContent = `${step} of ${steps}`;
        elements.back.disabled = step <= 1;
        elements.next.disabled = step >= steps;
        elements.reset.hidden = Object.keys(options).length === 0;
        showHandles(drawn.handles);
        showFields([...drawn.handles, ...drawn.typed]);
        root.host.dispatchEvent(new Event("drawn", { bubbles: true })); // page/letters.js
        const words = figure.querySelector("figcaption details p");
        if (words && drawn.words)
            words.textContent = drawn.words;
    }

    const valueOf = (handle) => Object.values(handle.options).join(", ");

    function showHandles(handles) {
        const width = WIDTHS[shown.shape];
        while (elements.handles.children.length < handles.length)
            elements.handles.append(newHandle(elements.handles.children.length));
        while (elements.handles.children.length > handles.length)
            elements.handles.lastChild.remove();
        handles.forEach((handle, i) => {
            const button = elements.handles.children[i];
            button.hidden = handle.u === undefined;
            button.style.left = `${(100 * handle.u) / width}%`;
            button.style.top = `${100 * (1 - handle.v / HEIGHT)}%`;
            button.setAttribute("aria-label", `${handle.words}: ${valueOf(handle)}. Drag it, or use the arrow keys`);
            button.title = `${handle.words}: ${valueOf(handle)}`;
        });
    }

    function showFields(all) {
        const fields = all.flatMap(({ words, options: its }) => Object.entries(its).map(([option, value]) => ({ words, option, value })));
        const known = [...elements.fields.querySelectorAll("input")];
        if (!same(known.map((each) => each.name), fields.map((each) => each.option))) {
            elements.fields.replaceChildren(...fields.map(newField));
            fold();
        }
        elements.fields.querySelectorAll("input").forEach((input, i) => {
            if (input !== root.activeElement || input.value === input.dataset.was)
                input.value = fields[i].value;
            input.dataset.was = fields[i].value;
        });
    }

    /** Fields for which the bar is too narrow are behind a button. */
    function fold() {
        elements.bar.classList.remove("folded");
        elements.bar.classList.toggle("folded", elements.fields.scrollWidth > elements.fields.clientWidth);
    }

    function newField({ words, option, value }) {
        const label = document.createElement("label"), input = document.createElement("input");
        input.name = option;
        input.title = words;
        input.className = value.includes(",") ? "" : "short";
        input.autocomplete = "off";
        input.spellcheck = false;
        label.append(option, input);
        input.addEventListener("change", () => {
            const before = options;
            const shownNow = [...shown.handles, ...shown.typed].map((each) => each.options); // numbers may go together
            const mine = options = { ...Object.assign({}, ...shownNow), ...options, [option]: input.value.replace(/\s/g, "").replaceAll("−", "-") };
            redraw({}, (drawn) => {
                if (!drawn && options === mine)
                    options = before;
            });
        });
        return label;
    }

    // ---- dragging -----------------------------------------------------------------------------------

    /** A place of the window on the canvas. */
    function onCanvas(x, y) {
        const box = elements.canvas.getBoundingClientRect();
        return { u: ((x - box.left) / box.width) * WIDTHS[shown.shape], v: HEIGHT * (1 - (y - box.top) / box.height) };
    }

    function newHandle(number) {
        const button = document.createElement("button");
        button.type = "button";
        button.className = "handle";
        button.setAttribute("aria-roledescription", "handle");
        button.addEventListener("pointerdown", (event) => {
            if (event.button > 0)
                return;
            event.preventDefault();
            button.focus({ preventScroll: true });
            button.setPointerCapture(event.pointerId);
            button.classList.add("held");
            const at = onCanvas(event.clientX, event.clientY), handle = shown.handles[number];
            held = { view: shown.view, du: handle.u - at.u, dv: handle.v - at.v };
        });
        button.addEventListener("pointermove", (event) => {
            if (!held || !button.hasPointerCapture(event.pointerId))
                return;
            const { u, v } = onCanvas(event.clientX, event.clientY);
            redraw({ held: held.view, beside: true, put: { handle: number, u: u + held.du, v: v + held.dv } });
        });
        const end = () => {
            if (!held)
                return;
            held = null;
            place.setAttribute("aria-busy", "true");
            button.classList.remove("held");
            finish(number);
        };
        button.addEventListener("pointerup", end);
        button.addEventListener("pointercancel", end);
        button.addEventListener("keydown", (event) => {
            const way = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
            if (!way)
                return;
            event.preventDefault();
            event.stopPropagation();
            const far = event.shiftKey ? A_LARGE_KEY : A_KEY, { u, v } = shown.handles[number];
            held ??= { view: shown.view };
            redraw({ held: held.view, put: { handle: number, by: { u, v, du: far * way[0], dv: far * way[1] } } });
            clearTimeout(keys);
            keys = setTimeout(() => { held = null; finish(number); }, AFTER_A_KEY);
        });
        return button;
    }

    /** After a drag, the whole figure: as large as it can be, with all its marks. */
    function finish(number) {
        questions.afterwards(() => redraw({}, (drawn) => {
            const handle = drawn?.handles[number];
            if (handle)
                elements.spoken.textContent = `${handle.words}: ${valueOf(handle)}. ${drawn.words}`;
        }));
    }

    // ---- steps --------------------------------------------------------------------------------------

    function go(by) {
        step = Math.max(1, Math.min(steps, step + by));
        redraw({}, (drawn) => {
            if (drawn)
                elements.spoken.textContent = `Step ${step} of ${steps}`;
        });
    }

    narrow.addEventListener("change", () => redraw());
    document.addEventListener("theme", () => redraw());
    redraw();
    return {
        goTo(wantedStep, then) {
            step = wantedStep;
            redraw({}, then);
        },
    };
}
