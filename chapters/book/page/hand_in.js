// hand_in.js - all answers as one archive, and back: what make submission packs and make grade reads.
import { makeZip, readZip } from "./zip.js";

const LARGEST = 256 * 1024; // bytes of an answer that the grader reads (tests/grade/collect/answers.py)

/** Hands the browser a file to save. */
function saveAs(name, bytes, type) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([bytes], { type }));
    link.download = name;
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** @returns {number} how many answers are in the archive */
export function download(stems, answers) {
    const files = stems.map((stem) => ({ name: `${stem}.c`, text: answers.text(stem) })).filter(({ text }) => text !== null)
        .map(({ name, text }) => ({ name, bytes: new TextEncoder().encode(text) }));
    const large = files.find(({ bytes }) => bytes.length > LARGEST);
    if (large)
        throw new Error(`${large.name} is larger than 256 KB. The grader reads no larger answer.`);
    if (files.length > 0)
        saveAs("submission.zip", makeZip(files), "application/zip");
    return files.length;
}

/**
 * The answers in some files: archives, and NN-stem.c.
 * @returns {Promise<Map<string, string>>} text of each stem
 */
export async function answersIn(fileList, stems) {
    const found = new Map();
    const stemOf = (path) => {
        // A second download of one file is called 'NN-stem (1).c' or 'NN-stem-1.c'.
        const base = path.split("/").pop().replace(/( ?\(\d+\)|-\d+)?\.c$/, "");
        return path.endsWith(".c") && stems.includes(base) ? base : null;
    };
    const add = (path, bytes) => {
        if (bytes.length > LARGEST)
            throw new Error(`${path} is larger than 256 KB`);
        const stem = stemOf(path), text = new TextDecoder().decode(bytes).replace(/\r\n/g, "\n");
        if (found.has(stem) && found.get(stem) !== text)
            throw new Error(`there are two different files ${stem}.c`);
        found.set(stem, text);
    };
    for (const file of fileList) {
        const bytes = new Uint8Array(await file.arrayBuffer());
        if (/\.zip$/i.test(file.name)) {
            // A copy of the toolkit or the handout has files of these names in other folders too.
            const inside = (await readZip(bytes, (name) => stemOf(name) !== null && !name.startsWith("__MACOSX")))
                .filter(({ name }) => !/(^|\/)(solutions|tests|build|chapters|common)\//.test(name));
            inside.forEach(({ name, bytes: content }) => add(name, content));
        } else if (stemOf(file.name)) {
            add(file.name, bytes);
        }
    }
    return found;
}
