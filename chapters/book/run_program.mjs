// run_program.mjs - runs a WebAssembly program from a shell: node run_program.mjs PROGRAM.wasm ARGUMENT...
//
// The program sees the files that its arguments name; those that it writes are written.
import { existsSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { basename } from "node:path";
import { run } from "./wasi.js";

const [path, ...args] = process.argv.slice(2);
const isFile = (name) => existsSync(name) && statSync(name).isFile();
/** @type {Map<string, Uint8Array>} */
const before = new Map(args.filter(isFile).map((name) => [name, readFileSync(name)]));
for (const name of args.filter((name) => name.includes("/") && !isFile(name)))
    before.set(name, new Uint8Array(0));
const result = run(new WebAssembly.Module(readFileSync(path)), { args: [basename(path, ".wasm"), ...args], files: before });
process.stdout.write(result.stdout);
process.stderr.write(result.stderr + (result.trap ? `${path}: ${result.error}\n` : ""));
for (const [name, bytes] of result.files.all())
    if (Buffer.compare(bytes, before.get(name) ?? new Uint8Array(0)) !== 0)
        writeFileSync(name, bytes);
process.exitCode = result.status ?? 1;
