// coloured_c.mjs - C code as HTML, coloured by the grammar that the editor uses.
import { StreamLanguage } from "@codemirror/language";
import { c } from "@codemirror/legacy-modes/mode/clike";
import { classHighlighter, highlightCode } from "@lezer/highlight";

const language = StreamLanguage.define(c);
const escape = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;");

export function colouredC(text) {
    let html = "";
    highlightCode(text, language.parser.parse(text), classHighlighter,
        (code, classes) => { html += classes ? `<span class="${classes}">${escape(code)}</span>` : escape(code); },
        () => { html += "\n"; });
    return html;
}
