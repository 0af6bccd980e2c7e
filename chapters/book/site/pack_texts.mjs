// pack_texts.mjs - text files as one JSON object: path to text. Runs when the site is built.
//
// Usage: node pack_texts.mjs FILE... where PATH=FILE is the file under another path
import { readFileSync } from "node:fs";

process.stdout.write(JSON.stringify(Object.fromEntries(process.argv.slice(2).sort().map((word) => {
    const [path, file = path] = word.split("=");
    return [path, readFileSync(file, "utf8")];
}))));
