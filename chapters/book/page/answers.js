// answers.js - a student's answers, kept in this browser: the text of each chapter, its older versions, its verdict.
//
// Everything is in localStorage, which other tabs of the site see at once. Its keys begin with the folder of the site, so
// that two courses on one host do not mix.

const VERSIONS = 20; // of each chapter

/**
 * @typedef {{text: string, why: string, when: number}} Version
 * @typedef {{of: string, right: number, total: number, done: boolean}} Verdict `of` is the text that was judged, in short
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
        saveJudged(stem, text, { record, right, total, done }) {
            put(key(stem, "record"), record);
            this.saveVerdict(stem, { of: nameOfText(text), right, total, done });
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
