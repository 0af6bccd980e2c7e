// strip_archive.mjs - a library without what only a debugger reads: Debian's libc.a is two thirds of that. Runs when the
// compiler's pack is made.
//
// Usage: node strip_archive.mjs LIBRARY.a OUT.a [MEMBER ...] where each MEMBER is left out
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";

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

mkdirSync(dirname(out), { recursive: true });
const folder = mkdtempSync(`${out}.`), stripped = [];
try {
    for (const { name, contents } of membersOf(readFileSync(library))) {
        if (leftOut.includes(name))
            continue;
        const own = join(folder, String(stripped.length)), file = join(own, name);
        mkdirSync(own);
        writeFileSync(join(own, "whole"), contents);
        execFileSync("wasm-ld", ["-r", "--strip-all", "-o", file, join(own, "whole")]);
        stripped.push(resolve(file));
    }
    rmSync(out, { force: true });
    execFileSync("llvm-ar", ["qcsD", out, ...stripped]);
} finally {
    rmSync(folder, { recursive: true });
}
