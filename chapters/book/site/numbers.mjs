// numbers.mjs - marks the numbers of the example in a lesson: each gets data-number="NAME", and the page changes it
// when a figure is dragged (page/numbers.js). Runs when the site is built.
//
// chapters/lessons/fill.py marks them in the markdown: U+E000 NAME U+E001 NUMBER U+E002.
import { existsSync, readFileSync } from "node:fs";
import katex from "katex";
import { typesetNumber } from "../page/typeset_number.js";

const MARKED = /\uE000(\w+)\uE001([^\uE002]*)\uE002/g;

/** The lesson with its numbers marked; the lesson itself if that is another one. */
export function withMarks(lesson, file) {
    const marked = existsSync(file) ? readFileSync(file, "utf8") : "";
    return marked.replace(MARKED, "$2") === lesson ? marked : lesson;
}

/**
 * A formula. It is there twice: for the eye, and as MathML for screen readers, where KaTeX keeps no name. So the MathML
 * is made apart, with the name of a number in its place.
 */
export function typeset(tex, displayMode) {
    const settings = { displayMode, throwOnError: true, strict: (code) => code === "htmlExtension" ? "ignore" : "error",
        trust: ({ command }) => command === "\\htmlData" };
    if (!tex.includes("\uE000"))
        return katex.renderToString(tex, settings);
    const numbers = Object.fromEntries([...tex.matchAll(MARKED)].map(([, name, text]) => [name, text]));
    const seen = katex.renderToString(tex.replace(MARKED, "\\htmlData{number=$1}{$2}"), settings);
    const read = katex.renderToString(tex.replace(MARKED, (_, name) => `\\text{number:${name.replaceAll("_", "\\_")}}`), { ...settings, output: "mathml" });
    const math = /<math.*<\/math>/s.exec(read)[0].replace(/<annotation.*<\/annotation>/s, "")
        .replace(/<mtext>number:(\w+)<\/mtext>/g, (_, name) => `<mtext data-number="${name}">${typesetNumber(numbers[name])}</mtext>`);
    return seen.replace(/<math.*<\/math>/s, () => math);
}

/** The marks outside of formulas. */
export const toSpans = (html) => html.replace(/\uE000(\w+)\uE001/g, '<span data-number="$1">').replaceAll("\uE002", "</span>");
