// pack_texts.mjs - text files as one JSON object: path to text. Runs when the site is built.
//
// Usage: node pack_texts.mjs FILE...
import { readFileSync } from "node:fs";

process.stdout.write(JSON.stringify(Object.fromEntries(process.argv.slice(2).sort().map((path) => [path, readFileSync(path, "utf8")]))));
