// verdict.js - what a page shows around the words of a verdict, from the judge's record (tests/course/chapter_record.h).

const unescaped = (value) => value.replace(/\\(n|t|\\|x..)/g, (_, what) =>
    what === "n" ? "\n" : what === "t" ? "\t" : what === "\\" ? "\\" : String.fromCharCode(parseInt(what.slice(1), 16)));

/** The functions of a record, in its order: {name, state, values}. None if the answer was not judged. */
export function functionsOf(record) {
    const functions = [];
    for (const line of record.split("\n").filter(Boolean)) {
        const tab = line.indexOf("\t"), key = line.slice(0, tab), value = unescaped(line.slice(tab + 1));
        if (key === "function")
            functions.push({ name: value, values: {} });
        else if (functions.length > 0)
            functions.at(-1).values[key] ??= value;
    }
    for (const each of functions)
        each.state = each.values.waits ? "waiting" : /crashed|timed out/.test(each.values.state) ? "wrong" : each.values.state;
    return functions;
}

/** The function that comes next: the first wrong one, or else the first that is not answered, or that waits. */
export const subjectOf = (functions) => ["wrong", "unanswered", "waiting"].map((state) => functions.find((each) => each.state === state)).find(Boolean) ?? null;

/** In which line of a text a function begins; 0 if it is not there. */
export function lineOf(text, name) {
    const found = new RegExp(`^[A-Za-z_][\\w \\t*]*\\b${name}\\s*\\([^;{]*\\{`, "m").exec(text);
    return found ? text.slice(0, found.index).split("\n").length : 0;
}

/** What the editor says at the line of a wrong function. */
export function markOf({ name, state, values }, text) {
    const line = lineOf(text, name);
    if (state !== "wrong" || line === 0)
        return [];
    const results = values.expected && !values.hidden ? `expected ${values.expected}, yours ${values.yours ?? ""}` : "not right yet";
    return [{ line, column: 1, severity: "warning", message: `${name}: ${(values.why || results).replaceAll("~", " ")}` }];
}

const element = (name, attributes, ...children) => {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes))
        made.setAttribute(key, value);
    made.append(...children);
    return made;
};
const STATES = { right: ["✓", "right"], wrong: ["✗", "not right yet"], unanswered: ["·", "not answered yet"], waiting: ["…", "waiting for another function"] };

/** Each function with its state, and the cause of what is wrong, large: a click leads to the function. */
export function summary(functions, text, goTo) {
    const subject = subjectOf(functions);
    const leading = (button, name) => { button.addEventListener("click", () => goTo(lineOf(text, name))); return button; };
    const strip = element("ol", { class: "strip", "aria-label": "The functions" }, ...functions.map(({ name, state }) => {
        const [mark, words] = STATES[state] ?? ["?", state];
        return element("li", { "data-state": state }, leading(element("button", { type: "button", title: `${name} is ${words}` },
            element("span", { "aria-hidden": "true" }, mark), name, element("span", { class: "aloud" }, `, ${words}`)), name));
    }));
    if (subject?.state !== "wrong")
        return functions.length > 0 ? [strip] : [];
    const why = subject.values.why || `${subject.name} is not right yet`;
    const line = lineOf(text, subject.name);
    return [strip, element("p", { class: "first" }, why[0].toUpperCase() + why.slice(1) + (/[.?!]$/.test(why) ? "" : "."),
        ...(line > 0 ? [" ", leading(element("button", { type: "button" }, `Line ${line}`), subject.name)] : []))];
}

/** After a chapter that is right: the way to the next one. */
export function wayOn(stem, { stems, titles }) {
    const next = stems[stems.indexOf(stem) + 1];
    return element("a", { class: "begin", href: next ? `${next}.html` : "index.html" }, next ? `Go on: ${titles[next]}` : "To the start page");
}
