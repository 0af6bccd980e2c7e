// figures.js - the figures of a page: a button that lets one fill the screen, where the arrow keys go through its steps
// and on to the next figure; and the live figure in the place of each static one.
import { liveFigure } from "../live_figure.js";
import { numbersFollow } from "./numbers.js";

/** The wide SVG of a static figure in a theme. A chart has one for both. */
const fileOf = (site, figure, theme) =>
    new URL(figure.dataset.src.replace(/\.svg$/, theme === "dark" && figure.querySelector("source") ? "-dark$&" : "$&"), site);

/** In the site of a handout, whose programs would hold answers. */
const areStatic = document.documentElement.dataset.figures === "static";

/**
 * @param {{site: URL, themeNow: () => string, drawer: import("./helper.js").Helper}} given drawer: figure_worker.js
 * @returns {{fetched: Promise<void>, shown: Promise<void>}} of the figures that are in sight at first: what they need is
 *          there; one of them is live. Both end also if there is none, or if it cannot be drawn.
 */
export function setUpFigures({ site, themeNow, drawer }) {
    const figures = [...document.querySelectorAll(".figure")];
    const view = fullScreenView({ site, themeNow, figures, drawer });
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
    // A figure becomes live when it is nearly in sight, and after the page is there.
    const seen = new IntersectionObserver((entries) => {
        const near = entries.filter((each) => each.isIntersecting);
        for (const { target } of near) {
            seen.unobserve(target);
            liveFigure(target, { ask: atFirst, themeNow, onDrawn: follow(target) });
        }
        if (near.length === 0) {
            first.fetched();
            first.shown();
        }
    }, { rootMargin: "300px" });
    figures.forEach((figure) => seen.observe(figure));
    return { fetched, shown };
}

function fullScreenView({ site, themeNow, figures, drawer }) {
    const dialog = document.createElement("dialog");
    dialog.className = "full";
    dialog.setAttribute("aria-label", "Figure on the full screen");
    dialog.innerHTML = `<div class="stage"><img alt=""></div><div class="bar"><p role="status"></p>
<button type="button" data-go="-1">Back</button><button type="button" data-go="1" class="main">Next</button><button type="button" data-close>Close</button></div>`;
    document.body.append(dialog);
    const img = dialog.querySelector("img"), status = dialog.querySelector("[role=status]");
    let at = 0, step = 0, steps = 0, opener = null, shown = 0;
    const current = () => ({ stem: figures[at].dataset.stem, name: figures[at].dataset.figure });

    /** The step as the live figure draws it; without it, the committed pictures of the first and the last step. */
    async function show() {
        const mine = ++shown, { stem, name } = current();
        const words = figures[at].querySelector("img")?.alt ?? "";
        img.alt = words;
        try {
            if (areStatic)
                throw new Error("there is no program");
            const drawn = await drawer.ask({ do: "figure", stem, name, theme: themeNow(), shape: "16:9", step: step || 1000 });
            if (mine !== shown)
                return;
            steps = drawn.steps;
            step ||= steps;
            img.src = `data:image/svg+xml,${encodeURIComponent(drawn.svg)}`;
            img.alt = drawn.words || words;
            status.textContent = `${drawn.title ?? ""}${steps > 1 ? `, step ${step} of ${steps}` : ""} (figure ${at + 1} of ${figures.length})`;
        } catch {
            if (mine !== shown)
                return;
            steps = step = 1;
            img.src = fileOf(site, figures[at], themeNow());
            status.textContent = `Figure ${at + 1} of ${figures.length}`;
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
        opener?.focus();
    });
    document.addEventListener("theme", () => { if (dialog.open) show(); });
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
