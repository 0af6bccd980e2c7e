// strip_archive.mjs - a library without what only a debugger reads: Debian's libc.a is two thirds of that. Runs when the
// compiler's pack is made.
//
// A member's debug sections are emptied, and what relocates them is left out; sections and symbols keep their numbers.
// (wasm-ld can do more, but takes 20 ms a member, and there are a thousand.)
//
// Usage: node strip_archive.mjs LIBRARY.a OUT.a [MEMBER ...] where each MEMBER is left out
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { Reader, sections } from "./cut.js";

const [library, out, ...leftOut] = process.argv.slice(2);
const HEADER = 60; // the bytes before each member: its name first, its size at 48

/** The members in their order. Two can have the same name, so llvm-ar does not extract them all. */
function* membersOf(bytes) {
    if (bytes.toString("latin1", 0, 8) !== "!<arch>\n")
        throw new Error(`${library} is not a library: expected !<arch> at its beginning`);
    let names = "";
    for (let at = 8; at + HEADER <= bytes.length;) {
        const field = (from, to) => bytes.toString("latin1", at + from, at + to).trim();
        const name = field(0, 16), size = Number(field(48, 58)), contents = bytes.subarray(at + HEADER, at + HEADER + size);
        at += HEADER + size + size % 2;
        if (name === "//")
            names = contents.toString("latin1");
        else if (name !== "/")
            yield { name: /^\/\d/.test(name) ? /[^/]*/.exec(names.slice(Number(name.slice(1))))[0] : name.replace(/\/$/, ""), contents };
    }
}

function stripped(object) {
    const kept = [object.subarray(0, 8)];
    let before = 8;
    for (const { id, from, to } of sections(object)) {
        const reader = new Reader(object, from), length = id === 0 ? reader.number() : 0, end = reader.at + length, name = object.toString("latin1", reader.at, end);
        if (name.startsWith(".debug_"))
            kept.push(Buffer.from([0, end - from]), object.subarray(from, end));
        else if (!name.startsWith("reloc..debug_"))
            kept.push(object.subarray(before, to));
        before = to;
    }
    return Buffer.concat(kept);
}

mkdirSync(dirname(out), { recursive: true });
const folder = mkdtempSync(`${out}.`), members = [];
try {
    for (const { name, contents } of membersOf(readFileSync(library))) {
        if (leftOut.includes(name))
            continue;
        const file = join(folder, String(members.length), name);
        mkdirSync(dirname(file));
        writeFileSync(file, stripped(contents));
        members.push(resolve(file));
    }
    rmSync(out, { force: true });
    execFileSync("llvm-ar", ["qcsD", out, ...members]);
} finally {
    rmSync(folder, { recursive: true });
}
