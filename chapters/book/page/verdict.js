// verdict.js - a verdict as a page shows it, made of the parts that the judge's program writes for a page
// (tests/course/page.h). All words are its own; here they are only put in their places.

export const element = (name, attributes, ...children) => {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes))
        made.setAttribute(key, value);
    made.append(...children);
    return made;
};
/** Hands the browser a file to save. */
export function saveAs(name, blob) {
    const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: name });
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
/** A formula at the beginning keeps its letter: "a is 0", but "A picture". */
export const sentence = (words) => words.replace(/^([a-z](?=[a-z])|a(?= (?!is )[a-z]{2}))/, (letter) => letter.toUpperCase()) + (/[.?!]$/.test(words) ? "" : ".");
/** A ~ holds a name and its number together. */
const spoken = (words) => words.replaceAll("~", "\u00a0");
const wordsOf = (parts, ...names) => parts.find(({ kind, label }) => names.includes(kind === "field" ? label : kind))?.words ?? "";

/** The function that a verdict is about, and in which line of the text it begins; 0 if it is not there. */
function subjectOf(parts, text) {
    const name = parts.find(({ kind }) => kind === "function")?.label ?? "";
    return { name, line: name ? lineOf(text, name) : 0 };
}
function lineOf(text, name) {
    const found = new RegExp(`^[A-Za-z_][\\w \\t*]*\\b${name}\\s*\\([^;{]*\\{`, "m").exec(text);
    return found ? text.slice(0, found.index).split("\n").length : 0;
}

/** What a compiler says, line by line; help: a sentence of the toolkit's own. */
function messagesOf(said, stem) {
    const messages = [];
    for (const line of said.split("\n")) {
        const [, at, column, severity, message] = new RegExp(`^exercises/${stem}\\.c:(\\d+):(\\d+): (?:fatal )?(error|warning): (.*)$`).exec(line) ?? [];
        if (message)
            messages.push({ line: Number(at), column: Number(column), severity, message, help: "" });
        else if (messages.length > 0 && /^ {2}(help: | {6})/.test(line)) // a long sentence goes on below itself
            messages.at(-1).help += ` ${line.slice(8).replaceAll("exercises/", "")}`;
    }
    return messages;
}

/** The sentence that matters first. */
function firstOf({ parts }, messages = []) {
    const { name } = subjectOf(parts), trouble = parts.find(({ kind }) => kind === "trouble");
    const first = wordsOf(parts, "right", "looks like", "but", "asked") || messages[0]?.message;
    return first ? sentence(spoken(first)) : trouble ? `${trouble.label} ${trouble.words}.` : name ? `${name} is not right yet.` : "";
}

/** What the editor says at a line: of the compiler, or of the function that is wrong. */
export function marksOf(verdict, stem, text) {
    const { parts, states } = verdict, said = wordsOf(parts, "compiler"), { name, line } = subjectOf(parts, text);
    const marks = messagesOf(said || verdict.messages, stem).map((each) => ({ ...each, message: each.message + each.help.replace(" ", "\n") }));
    if (line > 0 && states[name] === "wrong")
        marks.unshift({ line, column: 1, severity: "warning", message: firstOf(verdict), help: "" });
    return marks;
}

const STATES = { right: ["✓", "right"], wrong: ["✗", "not right yet"], unanswered: ["·", "not answered yet"], waiting: ["…", "waiting for another function"] };

/** Commas outside of parentheses separate what a value consists of. */
const fieldsOf = (value) => value.split(/, (?![^(]*\))/);

/** Expected and yours below or beside each other, with a mark where they differ. */
function comparison(expected, yours) {
    const row = (tag, ...cells) => element("tr", {}, ...cells.map((cell, at) => element(at === 0 ? "th" : tag, at === 0 ? { scope: "row" } : {}, cell)));
    const [a, b] = [expected, yours].map(fieldsOf), named = a.every((each) => each.includes("~"));
    if (a.length > 1 && named && a.length === b.length) {
        const head = element("tr", {}, element("td", {}), ...["expected", "yours"].map((each) => element("th", { scope: "col" }, each)));
        return element("table", { class: "results" }, head, ...a.map((each, at) => {
            const [, name, value] = /^([^~]*)~(.*)$/s.exec(each), mine = b[at].slice(name.length + 1), made = row("td", spoken(name), spoken(value), spoken(mine));
            made.classList.toggle("differs", value !== mine);
            return made;
        }));
    }
    const [left, right] = [expected, yours].map((each) => each.split(/(?<=,) /));
    const isVector = left.length === right.length && left.length > 1 && left.length < 5;
    const cells = (parts, others, isMine) => (isVector ? parts : [parts.join(" ")]).map((part, at) =>
        isMine && isVector && part !== others[at] ? element("mark", {}, spoken(part)) : spoken(part));
    return element("table", { class: "results" }, row("td", "expected", ...cells(left, right, false)), row("td", "yours", ...cells(right, left, true)));
}

function detailsOf(parts) {
    const fields = element("dl", {}), made = [];
    const put = (label, words) => fields.append(element("dt", {}, spoken(label)), element("dd", {}, spoken(words)));
    const flush = () => {
        if (fields.children.length > 0)
            made.push(fields.cloneNode(true));
        fields.replaceChildren();
    };
    const expected = wordsOf(parts, "expected");
    for (const { kind, label, words } of parts) {
        if (kind === "field" && label === "yours" && expected) {
            flush();
            made.push(comparison(expected, words));
        } else if (kind === "field" && !["expected", "asked", "but"].includes(label)) {
            put(label, words);
        } else if (kind === "looks like") {
            if (label)
                put(kind, label);
        } else if (kind === "and also") {
            put(kind, label ? `${label}: ${words}` : words);
        } else if (kind === "words") {
            flush();
            made.push(element("p", {}, spoken(words)));
        } else if (kind === "printed") {
            flush();
            made.push(element("p", {}, label), element("pre", {}, words));
        }
    }
    flush();
    return made;
}

/** Each function with its state, the first sentence with its line, and what there is to know: {strip, first, details}. */
export function shown(verdict, stem, text, goTo) {
    const { parts, states } = verdict, { name, line } = subjectOf(parts, text);
    const lineButton = (at) => leading(element("button", { type: "button" }, `Line ${at}`), at);
    const leading = (button, at) => { button.addEventListener("click", () => goTo(at)); return button; };
    const strip = Object.entries(states).map(([each, state]) => {
        const [mark, words] = STATES[state] ?? ["?", state];
        return element("li", { "data-state": state, ...(each === name ? { "aria-current": "true" } : {}) }, leading(element("button", { type: "button", title: `${each} is ${words}` },
            element("span", { "aria-hidden": "true" }, mark), each, element("span", { class: "aloud" }, `, ${words}`)), lineOf(text, each)));
    });
    const said = wordsOf(parts, "compiler"), messages = messagesOf(said, stem);
    const details = name ? [element("h4", {}, element("code", {}, name)), ...detailsOf(parts)] : detailsOf(parts);
    const trouble = parts.find(({ kind }) => kind === "trouble"), at = line || (trouble && messages[0]?.line) || 0;
    if (trouble)
        details.push(element("p", {}, messages[0]?.help ? sentence(messages[0].help.trim()) : "", ` ${trouble.label} ${trouble.words}.`));
    for (const each of messages.slice(trouble ? 1 : 0))
        details.push(element("p", {}, lineButton(each.line), ` ${sentence(each.message)}${each.help}`));
    if (said && messages.length === 0)
        details.push(element("pre", {}, said));
    return { strip, first: [firstOf(verdict, trouble ? messages : []), ...(at > 0 ? [" ", lineButton(at)] : [])], details };
}

/** After a chapter that is right: the way to the next one, and to the gallery of its mistakes, which a handout's site has not. */
export function wayOn(stem, { stems, titles }) {
    const next = stems[stems.indexOf(stem) + 1], hasGallery = document.documentElement.dataset.figures !== "static";
    return [element("a", { class: "begin", href: next ? `${next}.html` : "index.html" }, next ? `Go on: ${titles[next]}` : "To the start page"),
        ...(hasGallery ? [element("a", { class: "button", href: `mistakes.html#${stem}` }, "Look at what can go wrong")] : [])];
}
