// train.mjs - which of the compiler's functions are entered when answers are compiled.
//
// It compiles and links C files as the page does, and each of them again with random slips, as a student makes
// them, in a compiler whose functions note that they are entered (wasm-split --instrument). Each solution is also linked
// as a picture is, with and without the answers that it calls: in the site of a handout they may be missing. The
// functions that were ever entered are added to those of kept.txt, unless that is of another compiler. Usage, in
// chapters/book (make book-train does all of it):
//   node compiler/train.mjs INSTRUMENTED WHOLE PACK PICTURES KEPT SLIPS FILE.c ... > compiler/kept.new
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { Compiler, Program, unpack } from "../compiler.js";
import { toolsOf } from "../tools.js";
import { Files } from "../wasi.js";
import { keptList, keptText } from "./cut.js";

// Slips of the pen in a C text, as students make them: something left out, doubled, exchanged, misspelt.

const tokens = (text) => text.match(/\/\/[^\n]*|\/\*[^]*?\*\/|"(?:\\.|[^"\\\n])*"|[A-Za-z_]\w*|[\d.]+\w*|[-+*/%<>=!&|^]+|\s+|[^]/g);
const others = [
    "int", "double", ";", "(", ")", "{", "}", ",", "=", "==", "*", "&", ".", "->", "vec3", "x", "i", "0", "1.5",
    "return", "if", "else", "for", "while", "sqrt", "static", "const", "struct", '"text"', "!", "-", "+", "/", "%", "<", "&&", "[", "]",
    "NULL", "void", "float", "char", "'c'", "?", ":", "sizeof", "break", "switch", "case", "printf", "unsigned", "++", "+=", "#", "\\", "@"];

/**
 * @param {number} state where its random numbers begin
 * @returns {(text: string) => string} the text with a slip
 */
function slipsOf(state) {
    const random = (most) => {
        state = Math.imul(state, 1664525) + 1013904223 >>> 0;
        return Math.floor(state / 2 ** 32 * most);
    };
    return (text) => {
        const all = tokens(text), count = 1 + (random(4) === 0);
        for (let i = 0; i < count; i++) {
            let at = random(all.length);
            for (let tries = 0; tries < 20 && /^(\s|\/[/*])/.test(all[at]); tries++)
                at = random(all.length);
            const token = all[at], other = random(all.length);
            const how = random(8);
            if (how <= 1)
                all[at] = "";
            else if (how === 2)
                all[at] = token + token;
            else if (how === 3)
                [all[at], all[other]] = [all[other], token];
            else if (how === 4)
                all[at] = others[random(others.length)];
            else if (how === 5)
                all[at] = `${others[random(others.length)]} ${token}`;
            else if (how === 6)
                all[at] = token.slice(0, random(token.length)) + token.slice(1 + random(token.length));
            else if (/^\w{2}/.test(token))
                all[at] = random(2) ? token.toUpperCase() : `${token[1]}${token[0]}${token.slice(2)}`;
            else
                all[at] = all[other];
        }
        return all.join("");
    };
}

const [instrumented, whole, packed, pictures, keptBefore, slips, ...sources] = process.argv.slice(2);
const unpacked = (path) => unpack(new Uint8Array(readFileSync(path)));
const pack = unpacked(packed);

/** Adds up what its instances have noted. */
class NotingProgram extends Program {
    entered = [];
    begin() {
        if (this.exports)
            this.note();
        super.begin();
    }
    note() { // the profile: 8 bytes, then for each function when it was first entered, or 0
        const { exports } = this, pages = 16, at = exports.memory.grow(pages) << 16;
        const size = exports.__write_profile(at, pages << 16);
        new Uint32Array(exports.memory.buffer, at + 8, (size - 8) / 4).forEach((when, i) => { this.entered[i] |= when; });
    }
}
const program = new NotingProgram(new WebAssembly.Module(readFileSync(instrumented)));
const compiler = new Compiler(pack, program), slipped = slipsOf(2015);

/** As the page does it; a text that is no answer of a chapter is compiled as one, which the linker then says. */
async function compile(name, text) {
    const stem = name.match(/0[1-7]-[a-z-]+/)?.[0] ?? "05-quadratic";
    return { stem, ...await compiler.compile({ stem, files: { [`exercises/${stem}.c`]: text } }) };
}

const tools = toolsOf(compiler, unpacked(pictures)), answers = new Map();
function linkPictures() {
    for (const stem of answers.keys())
        for (const objects of [[stem], [...answers.keys()]])
            for (const drawing of ["link/drawing.o", `link/${stem}-program.o link/shared.a`])
                tools.link(["link", "-o", "picture", ...objects.map((name) => `${name}.o`), ...drawing.split(" "), "link/common.a"],
                    new Files(new Map([...answers].map(([name, object]) => [`${name}.o`, object]))));
}

const texts = sources.map((file) => [file.replace(/^(\.\.\/)+/, ""), readFileSync(file, "utf8")]);
for (const [i, [name, text]] of texts.entries()) {
    process.stderr.write(`\r${i + 1} of ${texts.length} files`);
    const { stem, object } = await compile(name, text);
    if (name.startsWith("solutions/0"))
        answers.set(stem, object);
}
linkPictures();
for (let i = 0; i < Number(slips); i++) {
    if (i % 20 === 0)
        process.stderr.write(`\r${i} of ${slips} slips   `);
    const [name, text] = texts[i % texts.length];
    await compile(name, slipped(text));
}
process.stderr.write("\n");

program.note();
const hash = createHash("sha256").update(readFileSync(whole)).digest("hex"), before = keptList(readFileSync(keptBefore, "utf8"));
process.stdout.write(keptText(hash, program.entered.map((when, i) => when || (before.hash === hash && before.isKept(i)))));
