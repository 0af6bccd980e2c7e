// answers.js - a student's answers, kept in this browser: the text of each chapter, its older versions, its verdict; and all
// as one archive, and back.
//
// Everything is in localStorage, which other tabs of the site see at once. Its keys begin with the folder of the site, so
// that two courses on one host do not mix.

import { saveAs } from "./verdict.js";

const VERSIONS = 20; // of each chapter

/**
 * @typedef {{text: string, why: string, when: number}} Version
 * @typedef {{of: string, right: number, total: number, done: boolean, states?: Object<string, string>}} Verdict `of` is the text
 *     that was judged, in short; states: of each function
 */

/** A short name of a text: equal texts have equal names. */
export function nameOfText(text) {
    let a = 0x811c9dc5, b = 0x1b873593;
    for (let i = 0; i < text.length; i++) {
        a = Math.imul(a ^ text.charCodeAt(i), 0x01000193);
        b = Math.imul(b + text.charCodeAt(i), 0x85ebca6b) ^ (b >>> 13);
    }
    return (a >>> 0).toString(16) + (b >>> 0).toString(16) + text.length.toString(16);
}

/**
 * @param {object} of
 * @param {Storage | null} of.storage localStorage, or null if the browser refuses it
 * @param {string} of.folder the folder of the site
 * @param {(words: string) => void} of.onTrouble called if something could not be kept, with words for the student; with
 *     none if all is kept again
 */
export function openAnswers({ storage, folder, onTrouble }) {
    const key = (stem, what = "answer") => `ray-casting ${folder} ${stem} ${what}`;
    const memory = new Map(); // what this page knows, even if the browser keeps nothing
    const refused = new Set(); // of that, what the browser has not kept: what it has there is older

    function read(name) {
        if (refused.has(name))
            return memory.get(name);
        try {
            return storage?.getItem(name) ?? memory.get(name) ?? null;
        } catch {
            return memory.get(name) ?? null;
        }
    }

    function put(name, value) {
        memory.set(name, value);
        try {
            if (storage === null)
                throw new Error("no storage");
            storage.setItem(name, value);
            if (refused.delete(name) && refused.size === 0)
                onTrouble("");
            return true;
        } catch (reason) {
            refused.add(name);
            const isFull = /quota/i.test(`${reason?.name} ${reason?.message}`) && storage?.length > 0;
            onTrouble(isFull
                ? "The browser has no more room to save your answers. Download them before you leave this page."
                : "This browser does not save your answers (a private window, or a setting). Download them before you leave this page.");
            return false;
        }
    }

    function readJson(name, otherwise) {
        try {
            return JSON.parse(read(name)) ?? otherwise;
        } catch {
            return otherwise;
        }
    }

    return {
        /** The saved text of a chapter; null if there is none. */
        text: (stem) => read(key(stem)),
        /** Saves a text; false if the browser does not keep it. */
        save: (stem, text) => put(key(stem), text),
        /** Keeps the text that is about to be replaced. */
        keepVersion(stem, why) {
            const text = read(key(stem));
            if (text === null)
                return;
            const versions = readJson(key(stem, "versions"), []);
            if (versions.at(-1)?.text !== text)
                versions.push({ text, why, when: Date.now() });
            put(key(stem, "versions"), JSON.stringify(versions.slice(-VERSIONS)));
        },
        /** @returns {Version[]} the newest is the last */
        versions: (stem) => readJson(key(stem, "versions"), []),
        /** The newest version, which is removed from the list. */
        takeVersion(stem) {
            const versions = readJson(key(stem, "versions"), []);
            const last = versions.pop() ?? null;
            put(key(stem, "versions"), JSON.stringify(versions));
            return last;
        },
        /** @returns {Verdict | null} of the text that is saved now */
        verdict(stem) {
            const verdict = readJson(key(stem, "verdict"), null);
            return verdict && verdict.of === nameOfText(read(key(stem)) ?? "") ? verdict : null;
        },
        saveVerdict: (stem, verdict) => put(key(stem, "verdict"), JSON.stringify(verdict)),
        /** Keeps what the judge said of a text. */
        saveJudged(stem, text, { record, right, total, done, states }) {
            put(key(stem, "record"), record);
            this.saveVerdict(stem, { of: nameOfText(text), right, total, done, states });
        },
        /** The chapters with right functions: their texts, and the names of these. */
        right(stems) {
            const found = {};
            for (const stem of stems) {
                const used = Object.entries(this.verdict(stem)?.states ?? {}).filter(([, state]) => state === "right").map(([name]) => name);
                if (used.length > 0)
                    found[stem] = { text: read(key(stem)), used };
            }
            return found;
        },
        /** Whether the browser has kept the text of a chapter. */
        isKept: (stem) => !refused.has(key(stem)),
        /** Anything else of a chapter that must outlive the page. */
        note: (stem, what) => read(key(stem, what)),
        saveNote: (stem, what, value) => put(key(stem, what), value),
        /** What another tab changed: the stem and 'answer', 'versions' or 'verdict'. */
        changeIn(event, stems) {
            for (const stem of stems)
                for (const what of ["answer", "versions", "verdict"])
                    if (event.key === key(stem, what))
                        return { stem, what };
            return null;
        },
    };
}

/** localStorage, if this browser has one that can be written. */
export function writableStorage() {
    try {
        const probe = "ray-casting probe";
        localStorage.setItem(probe, "1");
        localStorage.removeItem(probe);
        return localStorage;
    } catch {
        return null;
    }
}

// ---- all answers as one archive -------------------------------------------------------------------

// What make submission packs and make grade reads.

const LARGEST = 256 * 1024; // bytes of an answer that the grader reads (tests/grade/collect/answers.py)

/** @returns {Promise<number>} how many answers are in the archive */
export async function download(stems, answers) {
    const files = stems.map((stem) => ({ name: `${stem}.c`, text: answers.text(stem) })).filter(({ text }) => text !== null)
        .map(({ name, text }) => ({ name, bytes: new TextEncoder().encode(text) }));
    const large = files.find(({ bytes }) => bytes.length > LARGEST);
    if (large)
        throw new Error(`${large.name} is larger than 256 KB. The grader reads no larger answer.`);
    if (files.length > 0)
        saveAs("submission.zip", new Blob([await makeZip(files)], { type: "application/zip" }));
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

/**
 * @param {{name: string, bytes: Uint8Array}[]} files
 * @returns {Promise<Uint8Array<ArrayBuffer>>}
 */
export async function makeZip(files, when = new Date()) {
    const { zipSync } = await import("fflate");
    /** @type {import("fflate").ZipOptions} */
    const onUnix = { mtime: when, os: 3, attrs: 0o100644 * 0x10000, level: 0 };
    return zipSync(Object.fromEntries(files.map(({ name, bytes }) => [name, [bytes, onUnix]])));
}

/**
 * @param {Uint8Array} bytes
 * @param {(name: string) => boolean} wanted
 * @returns {Promise<{name: string, bytes: Uint8Array}[]>}
 */
export async function readZip(bytes, wanted = () => true) {
    const { unzipSync } = await import("fflate");
    try {
        return Object.entries(unzipSync(bytes, { filter: ({ name }) => wanted(name) })).map(([name, content]) => ({ name, bytes: content }));
    } catch (reason) {
        throw new Error(bytes[0] === 0x50 && bytes[1] === 0x4b ? `this archive is damaged (${reason.message})` : "this is not a zip archive", { cause: reason });
    }
}
