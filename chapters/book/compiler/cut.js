// cut.js - makes a small compiler of a whole one.
//
// Usage: node cut.js CLANG.wasm OUT.wasm [KEPT.txt], without a list of the functions that are kept: the whole compiler.
//
// Most of clang is never entered while a file of these exercises is compiled. Here each function that is
// not on a list becomes one that traps at once; all else stays as it is, so a cut compiler either does
// what the whole one does, or traps, and then the whole one is asked (compiler.js).
//
// It also opens the door for compiler.js to keep the memory that the program's constructors leave, because
// they take as long as compiling a small file: _start no longer calls them, and they are exported. So is the address of
// the data that a run may change: all data before it is constant. The heap
// begins with enough memory for an answer and its link, so that a run seldom needs more. It ends at 1 GB: an answer that
// is compiled without an end must not take the memory of the student's machine.
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const MEMORY = 5, GLOBALS = 6, EXPORTS = 7, CODE = 10, DATA = 11;
const PAGE = 1 << 16, MORE_PAGES = 240, MOST_PAGES = 1 << 14;
const FUNCTION = 0, GLOBAL = 3, I32 = 0x7f, CONSTANT = 0, END = 0x0b;
const CALL = 0x10, NOP = 0x01, BR_IF = 0x0d;
const TRAP = [3, 0, 0x00, 0x0b]; // its size, no locals, unreachable, end

/** The numbers of a module, one after another (LEB128). */
export class Reader {
    constructor(bytes, at = 0) { this.bytes = bytes; this.at = at; }
    number() {
        let value = 0;
        for (let unit = 1; ; unit *= 128) {
            const byte = this.bytes[this.at++];
            value += (byte & 127) * unit;
            if (byte < 128)
                return value;
        }
    }
}

function number(value) {
    const bytes = [];
    for (; value > 127; value = Math.floor(value / 128))
        bytes.push(value % 128 + 128);
    return [...bytes, value];
}

export function sections(bytes) {
    const found = [];
    for (const reader = new Reader(bytes, 8); reader.at < bytes.length;) {
        const id = reader.bytes[reader.at++], size = reader.number();
        found.push({ id, from: reader.at, to: reader.at + size });
        reader.at += size;
    }
    return found;
}

/** i32.const of an address: the linker writes it in five bytes. */
function constant(address) {
    const bytes = [0x41];
    for (let i = 0; i < 4; i++)
        bytes.push(address >>> 7 * i & 127 | 128);
    return [...bytes, address >>> 28];
}

function indexOf(bytes, wanted, from = 0) {
    for (let at = bytes.indexOf(wanted[0], from); at >= 0; at = bytes.indexOf(wanted[0], at + 1))
        if (wanted.every((byte, i) => bytes[at + i] === byte))
            return at;
    return -1;
}

const joined = (parts) => {
    const bytes = new Uint8Array(parts.reduce((size, part) => size + part.length, 0));
    let at = 0;
    for (const part of parts) { bytes.set(part, at); at += part.length; }
    return bytes;
};

const expected = (found, what) => {
    if (!found)
        throw new Error(`the compiler is another than the one that is cut here: no ${what}`);
    return found;
};

/**
 * _start without the calls of the constructors, and without its question whether it has run before.
 * @param {Uint8Array} body
 * @param {number} argsSizes the number of the import args_sizes_get, which comes right after them
 */
function startAgain(body, argsSizes) {
    const changed = body.slice();
    let reader, at, constructors = -1;
    // i32.const 0, i32.load 2 flag, br_if 0
    for (at = 0; at < 64; at++)
        if (body[at] === 0x41 && body[at + 1] === 0 && body[at + 2] === 0x28 && body[at + 3] === 2) {
            reader = new Reader(body, at + 4);
            reader.number();
            if (body[reader.at] === BR_IF)
                break;
        }
    expected(at < 64, "question in _start whether it has run before");
    changed.fill(NOP, at, reader.at + 2);
    for (at = 64; at < body.length; at++) {
        if (body[at] !== CALL || body[at + 5] > 127)
            continue;
        reader = new Reader(body, at + 1);
        const called = reader.number(), next = reader.at;
        const follows = [...body.subarray(next, next + 20)].join();
        if (follows.startsWith([0x20, 0, 0x41, 8, 0x6a, 0x20, 0, 0x41, 12, 0x6a, CALL, 128 + argsSizes].join())) {
            changed.fill(NOP, at, next);
            constructors = called;
            break;
        }
    }
    expected(constructors >= 0, "call of the constructors before that of args_sizes_get");
    return { body: changed, constructors };
}

/** The address of the second of two data segments: the linker writes constants first. */
function changingData(bytes, { from }) {
    const reader = new Reader(bytes, from);
    const segment = () => {
        expected(bytes[reader.at++] === 0 && bytes[reader.at++] === 0x41, "data at an address");
        const address = reader.number();
        reader.at++; // end
        const size = reader.number();
        reader.at += size;
        return address;
    };
    expected(reader.number() === 2, "constants and data");
    const constants = segment(), data = segment();
    return expected(data > constants && data, "constants before data");
}

/**
 * @param {Uint8Array} bytes the whole compiler
 * @param {(index: number) => boolean} isKept whether the function of that number, without the imported ones, stays
 * @returns {Uint8Array}
 */
export function cut(bytes, isKept) {
    const module = new WebAssembly.Module(bytes);
    const imported = WebAssembly.Module.imports(module).filter(({ kind }) => kind === "function").map(({ name }) => name);
    const all = sections(bytes);
    const exported = expected(all.find(({ id }) => id === EXPORTS), "exports");
    let reader = new Reader(bytes, exported.from), start = -1;
    for (let left = reader.number(); left > 0; left--) {
        const length = reader.number(), name = new TextDecoder().decode(bytes.subarray(reader.at, reader.at + length));
        reader.at += length;
        const kind = bytes[reader.at++], index = reader.number();
        if (kind === FUNCTION && name === "_start")
            start = index - imported.length;
    }
    // The memory at the start, and the constant from which malloc knows its end.
    const memory = expected(all.find(({ id }) => id === MEMORY), "memory");
    reader = new Reader(bytes, memory.from + 1);
    const hasMost = bytes[reader.at++], pages = reader.number();
    if (hasMost)
        reader.number();
    const larger = [1, 1, ...number(pages + MORE_PAGES), ...number(MOST_PAGES), ...bytes.subarray(reader.at, memory.to)];
    const end = constant(pages * PAGE), newEnd = constant((pages + MORE_PAGES) * PAGE);
    let ends = 0;
    const code = expected(all.find(({ id }) => id === CODE), "code");
    reader = new Reader(bytes, code.from);
    const count = reader.number(), bodies = [number(count)];
    let constructors;
    for (let i = 0; i < count; i++) {
        const from = reader.at, size = reader.number(), body = reader.at;
        reader.at += size;
        if (i === start) {
            const changed = startAgain(bytes.subarray(body, reader.at), imported.indexOf("args_sizes_get"));
            constructors = changed.constructors;
            bodies.push(number(changed.body.length), changed.body);
        } else if (!isKept(i)) {
            bodies.push(TRAP);
        } else {
            const kept = bytes.subarray(from, reader.at).slice();
            let at = indexOf(kept, end);
            if (at >= 0)
                ends++;
            for (; at >= 0; at = indexOf(kept, end, at))
                kept.set(newEnd, at);
            bodies.push(kept);
        }
    }
    expected(constructors !== undefined, "_start");
    expected(ends === 1, "one function that knows the end of the memory");
    // One global more, and its export.
    reader = new Reader(bytes, expected(all.find(({ id }) => id === GLOBALS), "globals").from);
    const globalCount = reader.number(), firstGlobal = reader.at;
    const data = [I32, CONSTANT, ...constant(changingData(bytes, expected(all.find(({ id }) => id === DATA), "data"))), END];
    const words = (name) => [name.length, ...new TextEncoder().encode(name)];
    const doors = [[...words("constructors"), FUNCTION, ...number(constructors)], [...words("stack"), GLOBAL, 0],
        [...words("data"), GLOBAL, ...number(globalCount)]].flat();
    reader = new Reader(bytes, exported.from);
    const exports = joined([number(reader.number() + 3), bytes.subarray(reader.at, exported.to), doors]);
    const parts = [bytes.subarray(0, 8)];
    for (const { id, from, to } of all) {
        const contents = id === EXPORTS ? exports : id === MEMORY ? larger : id === CODE ? joined(bodies)
      : id === GLOBALS ? joined([number(globalCount + 1), bytes.subarray(firstGlobal, to), data]) : bytes.subarray(from, to);
        parts.push([id], number(contents.length), contents);
    }
    return joined(parts);
}

// ---- the list of what is kept ---------------------------------------------------------------------

// The list of the functions that a cut compiler keeps, as text: the SHA-256 of the whole one, then a bit for each
// function in hexadecimal digits, 100 a line.
const DIGITS = 100;

/** @param {ArrayLike<number>} entered for each function, not 0 if it is kept */
export function keptText(hash, entered) {
    let text = "";
    for (let i = 0; i < entered.length; i += 4) {
        let digit = 0;
        for (let k = 0; k < 4; k++)
            digit |= (entered[i + k] ? 1 : 0) << k;
        text += digit.toString(16);
    }
    return `${hash}\n${text.replace(new RegExp(`.{1,${DIGITS}}`, "g"), "$&\n")}`;
}

/** @returns {{hash: string, isKept: (index: number) => boolean}} */
export function keptList(text) {
    const [hash, ...lines] = text.split("\n"), digits = lines.join("");
    return { hash, isKept: (index) => (parseInt(digits[index >> 2], 16) >> (index & 3) & 1) === 1 };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
    const [clang, out, kept] = process.argv.slice(2);
    const bytes = new Uint8Array(readFileSync(clang)), list = kept && keptList(readFileSync(kept, "utf8"));
    if (list && list.hash !== createHash("sha256").update(bytes).digest("hex")) {
        console.error(`${clang} is another compiler than the one of ${kept}: 'make book-train' makes that list again`);
        process.exit(1);
    }
    writeFileSync(out, cut(bytes, list ? list.isKept : () => true));
}
