// write_pack.js - puts files into one, for compiler.js to unpack.
//
// Usage: node write_pack.js OUT FLAGS.json PATH=FILE ... where FILE is put under the name PATH; a PATH that ends
// with '/' stands for all headers of the folder FILE, without C++. -PATH leaves out a file that was put there before.
import { readFileSync, readdirSync, writeFileSync } from "node:fs";

const [out, flags, ...given] = process.argv.slice(2);
const files = { "flags.json": readFileSync(flags) };

function addHeaders(path, folder) {
    for (const entry of readdirSync(folder, { withFileTypes: true }).sort((a, b) => a.name < b.name ? -1 : 1))
        if (entry.isDirectory() && entry.name !== "c++")
            addHeaders(`${path}${entry.name}/`, `${folder}/${entry.name}`);
        else if (entry.name.endsWith(".h"))
            files[path + entry.name] = readFileSync(`${folder}/${entry.name}`);
}

for (const word of given) {
    const [path, file] = word.split("=");
    if (word.startsWith("-"))
        delete files[word.slice(1)];
    else if (path.endsWith("/"))
        addHeaders(path, file);
    else
        files[path] = readFileSync(file);
}
const sizes = new TextEncoder().encode(JSON.stringify(Object.fromEntries(
    Object.entries(files).map(([path, bytes]) => [path, bytes.length]))));
const length = new Uint8Array(4);
new DataView(length.buffer).setUint32(0, sizes.length, true);
writeFileSync(out, Buffer.concat([length, sizes, ...Object.values(files)]));
