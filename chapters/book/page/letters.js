// letters.js - a letter of a formula under the pointer lights up: in all formulas of the lesson, in its figures, and in the
// code as what the lesson's own table, with the heading C, calls it. By key: a letter, while its formula is chosen.
const LETTER = ".katex-html .mathnormal:not(.mtight)";

/** A letter of KaTeX, or of a figure as gnuplot writes it, with its index: k_d. */
function nameOf(letter) {
    const next = letter.nextElementSibling, below = next?.matches(".msupsub") ? next.querySelector(".vlist-t2 .mtight") : next?.getAttribute("dy")?.startsWith("-") === false && next;
    return letter.textContent.trim() + (below ? `_${below.textContent}` : "");
}

/** The parts of a line that match, as ranges: one may begin in one colored piece and end in another. */
function rangesIn(line, pattern) {
    const nodes = [], walker = document.createTreeWalker(line, NodeFilter.SHOW_TEXT);
    for (let at = 0; walker.nextNode(); at += walker.currentNode.textContent.length)
        nodes.push({ node: walker.currentNode, at });
    return [...line.textContent.matchAll(pattern)].map(({ index, 0: { length } }) => {
        const range = document.createRange(), start = nodes.findLast(({ at }) => at <= index), end = nodes.findLast(({ at }) => at < index + length);
        range.setStart(start.node, index - start.at);
        range.setEnd(end.node, index + length - end.at);
        return range;
    }).filter((range) => !range.startContainer.parentElement.closest(".tok-comment"));
}

export function setUpLetters(lesson) {
    const names = {}; // k_d: surface->diffuse
    for (const row of lesson.querySelectorAll("table:has(th:last-child) tr")) {
        const codes = row.closest("table").querySelector("th:last-child").textContent === "C" ? [...row.querySelectorAll("td:last-child code")] : [];
        [...row.querySelectorAll(`td:first-child :is(${LETTER})`)].forEach((letter, i) => { names[nameOf(letter)] = codes[i]?.textContent; });
    }
    /** In C: the letter itself, ray.origin or moved_ray.origin, or a parameter of this name. */
    function patternOf(letter) {
        const parts = /^\w+((\.|->)\w+)*$/.exec(names[letter] ?? "")?.[0].split(/\W+/) ?? [];
        return new RegExp(`(?<![\\w.>])(?:${[letter.replace("_", ""), ...parts.length > 0 ? [`(?:\\w+_)?${parts.join("(?:\\.|->)")}`, parts.at(-1)] : []].join("|")})(?!\\w)`, "g");
    }
    let lit = "";
    const mark = (letters) => letters.forEach((each) => each.classList.toggle("lit", lit !== "" && nameOf(each) === lit));
    const markFigure = ({ shadowRoot }) => mark([...shadowRoot.querySelectorAll('tspan[font-style="italic"]')]);
    function light(letter) {
        if (letter === lit)
            return;
        lit = letter;
        mark([...lesson.querySelectorAll(LETTER)]);
        document.querySelectorAll(".figure .drawing > div").forEach(markFigure);
        const lines = [...lesson.querySelectorAll("code"), ...document.querySelector("#editor").shadowRoot?.querySelectorAll(".cm-line") ?? []];
        globalThis.CSS.highlights?.set("lit", new Highlight(...letter ? lines.flatMap((line) => rangesIn(line, patternOf(letter))) : []));
    }
    document.addEventListener("drawn", ({ target }) => markFigure(/** @type {Element} */ (target)));
    lesson.addEventListener("pointerover", ({ target }) => { const letter = target.closest(LETTER); light(letter ? nameOf(letter) : ""); });
    lesson.addEventListener("pointerleave", () => light(""));
    lesson.addEventListener("focusout", () => light(""));
    lesson.addEventListener("keydown", ({ key, target, ctrlKey, metaKey, altKey }) => {
        if (target.matches(".mathematics") && /^[A-Za-z]$/.test(key) && !ctrlKey && !metaKey && !altKey)
            light(key);
    });
}
