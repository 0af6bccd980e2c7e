// numbers.js - the numbers in the text of a lesson follow a figure that is dragged or typed into. The chapter's own C
// gives them (chapters/lessons/print_numbers.c). A reset of the figure brings the lecture's numbers back.

/** A number of a lesson, which is TeX in a formula, as text in a formula. */
export const typesetNumber = (tex) => tex.replaceAll("\\approx", "≈").replaceAll("-", "−");

/** What the lecture's number is made of, to put it back. */
const lecture = new WeakMap();

function show(place, text) {
    if (text === undefined) {
        if (lecture.has(place))
            place.replaceChildren(...lecture.get(place));
        place.classList.remove("follows");
        place.removeAttribute("title");
        return;
    }
    if (!lecture.has(place))
        lecture.set(place, [...place.childNodes]);
    // A sentence may have formulas in it; here they are plain text.
    place.textContent = place.closest(".katex") ? typesetNumber(text) : place.closest("code") ? text : text.replaceAll("$", "");
    place.classList.add("follows");
    const before = lecture.get(place);
    if (!before.some((each) => each.className === "katex")) // a formula is there twice
        place.title = `In the lecture: ${before.map((each) => each.textContent).join("")}`;
}

/**
 * @param {{stem: string, ask: (what: object) => Promise<{numbers: Object<string, string>}>}} given
 * @returns {(figure: object) => (drawn: {name: string, options: Object<string, string>}) => void} what a figure calls when it is drawn
 */
export function numbersFollow({ stem, ask }) {
    const places = [...document.querySelectorAll("[data-number]")], shown = new Map();
    let owner = null, next = null, busy = false;

    async function follow() {
        busy = true;
        for (let what; (what = next);) {
            next = null;
            const { numbers } = await ask({ do: "numbers", stem, ...what }).catch(() => ({ numbers: {} }));
            places.forEach((place) => show(place, numbers[place.dataset.number]));
        }
        busy = false;
    }

    return (figure) => ({ name, options }) => {
        const now = JSON.stringify(options), changed = now !== (shown.get(figure) ?? "{}");
        shown.set(figure, now);
        // A figure that is only drawn again does not take the numbers from the one that was changed last.
        if (places.length === 0 || !changed || (now === "{}" && owner !== figure))
            return;
        owner = figure;
        next = { name, options };
        if (!busy)
            follow();
    };
}
