// lesson.mjs - a lesson in markdown as HTML: mathematics typeset, code colored, links led to the pages of the site,
// and each figure ready to become live. Runs when the site is built.
import { existsSync, readFileSync } from "node:fs";
import { dirname, join, normalize } from "node:path";
import { StreamLanguage } from "@codemirror/language";
import { c } from "@codemirror/legacy-modes/mode/clike";
import { classHighlighter, highlightCode } from "@lezer/highlight";
import katex from "katex";
import markdownIt from "markdown-it";
import { typesetNumber } from "../page/numbers.js";

export const escape = (text) =>
    text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;");

const language = StreamLanguage.define(c);

/** C code as HTML, colored by the grammar that the editor uses. */
export function coloredC(text) {
    let html = "";
    highlightCode(text, language.parser.parse(text), classHighlighter,
        (code, classes) => { html += classes ? `<span class="${classes}">${escape(code)}</span>` : escape(code); },
        () => { html += "\n"; });
    return html;
}

// The numbers of the example in a lesson: each gets data-number="NAME", and the page changes it when a figure is dragged
// (page/numbers.js). chapters/lessons/fill.py marks them in the markdown: U+E000 NAME U+E001 NUMBER U+E002.

const MARKED = /\uE000(\w+)\uE001([^\uE002]*)\uE002/g;

/** The lesson with its numbers marked; the lesson itself if that is another one. */
function withMarks(lesson, file) {
    const marked = existsSync(file) ? readFileSync(file, "utf8") : "";
    return marked.replace(MARKED, "$2") === lesson ? marked : lesson;
}

/**
 * A formula. It is there twice: for the eye, and as MathML for screen readers, where KaTeX keeps no name. So the MathML
 * is made apart, with the name of a number in its place.
 */
function typeset(tex, displayMode) {
    const settings = { displayMode, throwOnError: true, strict: (code) => code === "htmlExtension" ? "ignore" : "error",
        trust: ({ command }) => command === "\\htmlData" };
    if (!tex.includes("\uE000"))
        return katex.renderToString(tex, settings);
    const numbers = Object.fromEntries([...tex.matchAll(MARKED)].map(([, name, text]) => [name, text]));
    const seen = katex.renderToString(tex.replace(MARKED, "\\htmlData{number=$1}{$2}"), settings);
    const read = katex.renderToString(tex.replace(MARKED, (_, name) => `\\text{number:${name.replaceAll("_", "\\_")}}`), { ...settings, output: "mathml" });
    const math = /<math.*<\/math>/s.exec(read)[0].replace(/<annotation.*<\/annotation>/s, "")
        // KaTeX joins texts that stand side by side.
        .replace(/<mtext>((?:number:\w+?)+)<\/mtext>/g, (_, names) => names.split("number:").slice(1)
            .map((name) => `<mtext data-number="${name}">${typesetNumber(numbers[name])}</mtext>`).join(""));
    return seen.replace(/<math.*<\/math>/s, () => math);
}

/** The marks outside of formulas. */
const toSpans = (html) => html.replace(/\uE000(\w+)\uE001/g, '<span data-number="$1">').replaceAll("\uE002", "</span>");

/** `$...$` as GitHub reads it: no space inside the dollars, no digit after them. */
function inlineMathematics(markdown) {
    markdown.inline.ruler.before("escape", "mathematics", (state, silent) => {
        const found = /^\$(?!\s)((?:\\.|[^$\\\n]|\n(?!\n))+?)(?<!\s)\$(?!\d)/.exec(state.src.slice(state.pos));
        if (!found)
            return false;
        if (!silent)
            state.push("mathematics", "", 0).content = found[1];
        state.pos += found[0].length;
        return true;
    });
    markdown.renderer.rules.mathematics = (tokens, at) => typeset(tokens[at].content, false);
}

const slug = (text) => text.toLowerCase().replace(/<[^>]*>/g, "").replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "");

/** Headings that a link can lead to. */
function headings(markdown) {
    markdown.core.ruler.push("heading-ids", (state) => {
        state.tokens.forEach((token, at) => {
            if (token.type === "heading_open")
                token.attrSet("id", slug(state.tokens[at + 1].content));
        });
    });
}

/**
 * A lesson is also read beside the toolkit in a terminal. What is only for that is left out: commands, which are fences of
 * sh, and what is between <!-- terminal --> and <!-- /terminal -->. <!-- page: WORDS --> are words for the page only.
 */
const forPage = (markdown) => markdown.replace(/ `make optional [^`]*`/g, "").replace(/\n*<!-- terminal -->\n?.*?<!-- \/terminal -->/gs, "").replace(/<!-- page: (.*?) -->/gs, "$1");

/** How a verdict is asked for, in the place of the command for it. */
const JUDGES = '<p><a href="#exercise">Judge it</a>: press <kbd>Ctrl</kbd> <kbd>Enter</kbd>, or stop typing for a moment.</p>\n';

function fences(markdown, isChapter) {
    markdown.renderer.rules.fence = (tokens, at) => {
        const { content, info } = tokens[at];
        const language = info.trim();
        if (language === "math")
            return `<div class="mathematics" tabindex="0">${typeset(content, true)}</div>\n`;
        if (language === "sh" && isChapter)
            return /^make exercises EX=\d\d\s*$/.test(content) ? JUDGES : "";
        return `<pre tabindex="0"><code>${language === "c" ? coloredC(content) : escape(content)}</code></pre>\n`;
    };
}

/** Width and height of a PNG, from its first chunk. */
function sizeOfPng(file) {
    const bytes = readFileSync(file);
    return { width: bytes.readUInt32BE(16), height: bytes.readUInt32BE(20) };
}

/**
 * A static figure that the page can replace by the live one: the picture, its words, and room for a button.
 * A figure with a layout is four files, drawn for the site: wide and narrow, light and dark. A chart is the lesson's file.
 * @param {object} of
 * @param {string} of.root the folder of the toolkit
 * @param {string} of.file the lesson's SVG, chapters/NN-stem/NAME[-stepN].svg
 * @param {string} of.words
 * @param {boolean} of.first in the page: it is fetched at once
 * @param {Set<string>} of.used gets the path in the site of each SVG
 */
export function figure({ root, file, words, first, used }) {
    const [, stem, name, step] = /^chapters\/([^/]+)\/([^/]+?)(?:-step(\d+))?\.svg$/.exec(file);
    const isDrawn = existsSync(join(root, `chapters/${stem}/figures/${name}.gp`));
    const use = (path) => {
        used.add(path);
        return path;
    };
    const drawn = (shape, theme) => use(`chapters/${stem}/figures/${name}${shape}${step ? `-step${step}` : ""}${theme}.svg`);
    const src = isDrawn ? drawn("", "") : use(file);
    const sources = isDrawn ? `<source media="(max-width: 600px) and (prefers-color-scheme: dark)" srcset="${drawn("-4x3", "-dark")}">` +
        `<source media="(max-width: 600px)" srcset="${drawn("-4x3", "")}">` +
        `<source media="(prefers-color-scheme: dark)" srcset="${drawn("", "-dark")}">` : "";
    return `<figure class="figure" data-stem="${stem}" data-figure="${name}"${step ? ` data-step="${step}"` : ""} data-src="${src}">
<div class="drawing"><picture>${sources}<img width="960" height="540" ${first ? 'fetchpriority="high"' : 'loading="lazy"'} decoding="async" alt="${words}" src="${src}"></picture></div>
<figcaption><details><summary>In words</summary><p>${words}</p></details></figcaption>
</figure>`;
}

/**
 * A markdown file as HTML.
 * @param {object} of
 * @param {string} of.root the folder of the toolkit
 * @param {string} of.path the file, in that folder
 * @param {(path: string) => string | null} of.pageOf the page of the site for a file of the toolkit; null if there is none
 * @param {Set<string>} of.used gets the path of each picture that the page needs
 * @param {string} [of.marked] the same file with its numbers marked, if there is one (withMarks)
 * @param {string} [of.up] from the page to the top of the site: "" or "../"
 */
export function lessonHtml({ root, path, pageOf, used, marked = "", up = "" }) {
    const source = readFileSync(join(root, path), "utf8"), isChapter = path.endsWith("/README.md") && path.startsWith("chapters/");
    const resolve = (link) => normalize(join(dirname(path), link));
    const use = (link) => {
        const file = resolve(link);
        if (!existsSync(join(root, file)))
            throw new Error(`${path}: there is no ${file}`);
        used.add(file);
        return up + file;
    };

    const markdown = markdownIt({ html: true, typographer: false }).use(inlineMathematics).use(headings).use(fences, isChapter);
    const plainLink = (tokens, at, options, env, self) => self.renderToken(tokens, at, options);
    markdown.renderer.rules.link_open = (tokens, at, ...rest) => {
        const link = String(tokens[at].attrGet("href"));
        if (/^[a-z]+:/.test(link)) {
            tokens[at].attrSet("rel", "noopener");
            return plainLink(tokens, at, ...rest);
        }
        const [file, place = ""] = link.split("#");
        const page = file === "" ? "" : pageOf(resolve(file));
        if (page === null) {
            tokens[tokens.findIndex((token, after) => after > at && token.type === "link_close")].hidden = true;
            tokens[at].hidden = true;
            return "";
        }
        tokens[at].attrSet("href", (page && up + page) + (place && `#${place}`));
        return plainLink(tokens, at, ...rest);
    };
    markdown.renderer.rules.link_close = (tokens, at) => (tokens[at].hidden ? "" : "</a>");

    let first = true;
    const lazily = () => {
        const attributes = first ? "" : ' loading="lazy"';
        first = false;
        return attributes;
    };
    markdown.renderer.rules.image = (tokens, at, options, env, self) => {
        const words = escape(self.renderInlineAsText(tokens[at].children, options, env));
        const file = resolve(tokens[at].attrGet("src"));
        if (file.endsWith(".svg")) {
            const made = figure({ root, file, words, first, used });
            first = false;
            return made;
        }
        const { width, height } = sizeOfPng(join(root, file));
        return `<img class="picture" alt="${words}" src="${use(tokens[at].attrGet("src"))}" width="${width}" height="${height}"${lazily()}>`;
    };

    const text = withMarks(source, marked), html = toSpans(markdown.render(isChapter ? forPage(text) : text))
        .replace(/<p>(<figure .*?<\/figure>)<\/p>/gs, "$1")
        .replace(/<table>/g, '<div class="table" tabindex="0"><table>').replace(/<\/table>/g, "</table></div>")
        .replace(/<thead>\s*<tr>\s*(<th>\s*<\/th>\s*)+<\/tr>\s*<\/thead>/g, "")
        .replace(/<p>((?:<img class="picture"[^>]*>\s*)+)<\/p>/g, '<p class="pictures">$1</p>');
    return { html, title: /^# (.*)$/m.exec(source)?.[1] ?? path, time: /^\| time \| (.*) \|$/m.exec(source)?.[1] ?? "",
        gives: /^\| gives \| (.*) \|$/m.exec(source)?.[1] ?? "" };
}
