// editor.js - the editor of an answer: CodeMirror with C, saved on each change, errors marked at their lines.
import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { bracketMatching, indentOnInput, indentUnit, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { c } from "@codemirror/legacy-modes/mode/clike";
import { lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { Annotation, EditorState, StateEffect, StateField } from "@codemirror/state";
import { Decoration, drawSelection, EditorView, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers, WidgetType } from "@codemirror/view";
import { classHighlighter } from "@lezer/highlight";

const byProgram = Annotation.define();

/** What was said of a line, after it: the first sentence. The whole of it is in the mark at its side. */
class Said extends WidgetType {
    constructor({ message, severity }) { super(); this.words = message.split("\n")[0]; this.severity = severity; }
    eq(other) { return other.words === this.words && other.severity === this.severity; }
    toDOM() { return Object.assign(document.createElement("span"), { className: `said ${this.severity}`, textContent: this.words, ariaHidden: "true" }); }
}
/** @type {import("@codemirror/state").StateEffectType<import("@codemirror/view").DecorationSet>} */
const sayings = StateEffect.define();
const sayingsOfLines = StateField.define({
    create: () => Decoration.none,
    update(now, { changes, effects }) {
        return effects.find((each) => each.is(sayings))?.value ?? now.map(changes);
    },
    provide: (field) => EditorView.decorations.from(field),
});

/** Completes the functions of a contract, each with the comment above it. */
function completeFrom(contract) {
    const options = [...contract.matchAll(/((?:^\/\/.*\n)*)^[A-Za-z_][\w *]*?\b(\w+)(\([^;{]*\));/gm)].map(([, comment, label, parameters]) =>
        ({ label, type: "function", detail: parameters.replace(/\s+/g, " "), info: comment.replace(/^\/\/ ?/gm, "").trim() || undefined }));
    return (context) => {
        const word = context.matchBefore(/\w{2,}/);
        return word || context.explicit ? { from: word?.from ?? context.pos, options, validFor: /^\w*$/ } : null;
    };
}

/**
 * @param {object} of
 * @param {HTMLElement} of.place
 * @param {string} of.label read aloud
 * @param {string} of.text
 * @param {string} of.contract the header of the exercise: its functions are completed
 * @param {(text: string) => void} of.onChange the student changed the text
 * @param {() => void} of.onJudge Ctrl-Enter or Cmd-Enter
 */
export function openEditor({ place, label, text, contract, onChange, onJudge }) {
    // In a shadow root CodeMirror's styles are constructed style sheets, which the site's policy allows.
    const shadow = place.attachShadow({ mode: "open", delegatesFocus: true });
    const parent = Object.assign(document.createElement("div"), { className: "place" });
    shadow.append(document.querySelector("link[rel=stylesheet]").cloneNode(), parent);
    const judge = { run: () => { onJudge(); return true; }, preventDefault: true };
    const view = new EditorView({
        parent,
        root: shadow,
        state: EditorState.create({
            doc: text,
            extensions: [
                lineNumbers(), highlightActiveLineGutter(), highlightActiveLine(), history(), drawSelection({ cursorBlinkRate: 0 }), indentOnInput(), bracketMatching(),
                closeBrackets(), highlightSelectionMatches(), sayingsOfLines, autocompletion({ override: [completeFrom(contract)] }),
                lintGutter(), StreamLanguage.define(c), syntaxHighlighting(classHighlighter), indentUnit.of("    "), EditorState.tabSize.of(4),
                keymap.of([{ key: "Mod-Enter", ...judge }, { key: "Ctrl-Enter", ...judge }, ...closeBracketsKeymap, ...defaultKeymap, ...searchKeymap, ...historyKeymap,
                    ...completionKeymap, ...lintKeymap, indentWithTab]),
                EditorView.contentAttributes.of({ "aria-label": label, tabindex: "0", spellcheck: "false", autocorrect: "off", autocapitalize: "off" }),
                EditorView.updateListener.of((update) => {
                    if (update.docChanged && !update.transactions.some((each) => each.annotation(byProgram)))
                        onChange(update.state.doc.toString());
                }),
            ],
        }),
    });
    return {
        text: () => view.state.doc.toString(),
        /** Another text, which Ctrl-Z takes back. The place of the cursor stays where it can. */
        replace(other) {
            const now = view.state.doc.toString();
            let start = 0, end = 0;
            const least = Math.min(now.length, other.length);
            while (start < least && now[start] === other[start])
                start++;
            while (end < least - start && now[now.length - 1 - end] === other[other.length - 1 - end])
                end++;
            view.dispatch({ changes: { from: start, to: now.length - end, insert: other.slice(start, other.length - end) }, annotations: byProgram.of(true) });
        },
        /** @param {{line: number, column: number, severity: any, message: string}[]} marks severity: "error" or "warning"; lines count from 1 */
        mark(marks) {
            const { doc } = view.state;
            const inText = marks.filter(({ line }) => line >= 1 && line <= doc.lines);
            view.dispatch({ effects: sayings.of(Decoration.set(inText.filter(({ line }, at) => inText.findIndex((each) => each.line === line) === at)
                .map((each) => Decoration.widget({ widget: new Said(each), side: 1 }).range(doc.line(each.line).to)), true)) });
            view.dispatch(setDiagnostics(view.state, inText.map(({ line, column, severity, message }) => {
                const { from, to, text: words } = doc.line(line);
                const start = Math.min(from + Math.max(column - 1, 0), to);
                const word = /^\w+/.exec(words.slice(start - from))?.[0].length ?? 1;
                return { from: start, to: Math.min(start + word, to), severity, message };
            })));
        },
        /** @param {number} line */
        goTo(line) {
            const { from } = view.state.doc.line(Math.min(Math.max(line, 1), view.state.doc.lines));
            view.dispatch({ selection: { anchor: from }, effects: EditorView.scrollIntoView(from, { y: "center" }) });
            view.focus();
        },
        focus: () => view.focus(),
    };
}
