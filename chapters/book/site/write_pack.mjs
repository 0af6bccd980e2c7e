// write_pack.mjs - puts files into one: texts into OUT.json, path to text; others as compiler.js unpacks them. Runs when the
// site is built.
//
// Usage: node write_pack.mjs OUT PATH=FILE ... where FILE is put under the name PATH, or FILE under its own name. A PATH
// that ends with '/' stands for all headers of the folder FILE, without C++. -PATH leaves out a file that was put there before.
import { readFileSync, readdirSync, writeFileSync } from "node:fs";

const [out, ...given] = process.argv.slice(2);
/** @type {Map<string, Buffer>} */
const files = new Map();

function addHeaders(path, folder) {
    for (const entry of readdirSync(folder, { withFileTypes: true }).sort((a, b) => a.name < b.name ? -1 : 1))
        if (entry.isDirectory() && entry.name !== "c++")
            addHeaders(`${path}${entry.name}/`, `${folder}/${entry.name}`);
        else if (entry.name.endsWith(".h"))
            files.set(path + entry.name, readFileSync(`${folder}/${entry.name}`));
}

for (const word of given) {
    const [path, file = path] = word.split("=");
    if (word.startsWith("-"))
        files.delete(word.slice(1));
    else if (path.endsWith("/"))
        addHeaders(path, file);
    else
        files.set(path, readFileSync(file));
}
const listed = (what) => Buffer.from(JSON.stringify(Object.fromEntries([...files].map(([path, bytes]) => [path, what(bytes)]))));
const sizes = listed((bytes) => bytes.length), length = Buffer.alloc(4);
length.writeUInt32LE(sizes.length);
writeFileSync(out, out.endsWith(".json") ? listed(String) : Buffer.concat([length, sizes, ...files.values()]));
