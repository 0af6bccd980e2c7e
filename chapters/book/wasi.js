// wasi.js - runs one WebAssembly program: WASI preview 1, with its files in memory.
//
// Every C program of the page runs by it, and the compiler too. It works in a page, in a Worker and
// in node. A program is compiled once (a WebAssembly.Module), and each run is a fresh instance, so
// nothing of a run is left but the files, which the caller gets back.

const OK = 0, BAD_FILE = 8, EXISTS = 20, INVALID = 28, IS_FOLDER = 31, NO_ENTRY = 44,
    NOT_THERE = 52, NO_FOLDER = 54, TOO_BIG = 22;
const CHARACTERS = 2, FOLDER = 3, FILE = 4;
const OPEN_CREATE = 1, OPEN_FOLDER = 2, OPEN_NEW = 4, OPEN_EMPTY = 8, APPEND = 1;
const TOP = 3; // the descriptor of the folder of all files

const words = new TextEncoder(), text = new TextDecoder();

/** How a program ended besides returning: by exit, or after too many steps. */
export class Exit extends Error {
    constructor(status) { super(`exit ${status}`); this.status = status; }
}
export class OutOfSteps extends Error {}

/** A file in memory, which grows. */
class MemoryFile {
    constructor(bytes, number) { this.bytes = bytes; this.size = bytes.length; this.number = number; this.most = Infinity; }
    contents() { return this.bytes.subarray(0, this.size); }
    resize(size) {
        if (size > this.bytes.length) {
            const bytes = new Uint8Array(Math.max(size, 2 * this.bytes.length, 256));
            bytes.set(this.contents());
            this.bytes = bytes;
        } else if (size < this.size && this.isShared) {
            this.bytes = this.bytes.slice();
        }
        if (size < this.size)
            this.bytes.fill(0, size, this.size);
        this.isShared = false;
        this.size = size;
    }
    write(bytes, at) {
        if (at + bytes.length > this.most)
            return false;
        if (this.isShared) { this.bytes = this.bytes.slice(); this.isShared = false; }
        if (at + bytes.length > this.size)
            this.resize(at + bytes.length);
        this.bytes.set(bytes, at);
        return true;
    }
}

/** 'a/./b/../c' and '/a/c' are 'a/c'; the top is ''. */
function plainPath(path) {
    const parts = [];
    for (const part of path.split("/"))
        if (part === "..")
            parts.pop();
        else if (part !== "" && part !== ".")
            parts.push(part);
    return parts.join("/");
}

/** The files of a run: paths from the top, without a slash in front. */
export class Files {
    /** @param {Map<string, Uint8Array|string>|Object<string, Uint8Array|string>} [given] */
    constructor(given = new Map()) {
        this.files = new Map();
        this.folders = new Map([["", 1]]);
        this.next = 2;
        for (const [path, contents] of given instanceof Map ? given : Object.entries(given))
            this.put(path, contents);
    }
    put(path, contents) {
        path = plainPath(path);
        const file = new MemoryFile(typeof contents === "string" ? words.encode(contents) : contents, this.next++);
        file.isShared = true; // the caller's bytes stay as they are
        this.addFolder(path.split("/").slice(0, -1).join("/"));
        this.files.set(path, file);
        return file;
    }
    addFolder(path) {
        for (; !this.folders.has(path); path = path.split("/").slice(0, -1).join("/"))
            this.folders.set(path, this.next++);
    }
    get(path) { return this.files.get(plainPath(path))?.contents(); }
    text(path) { const bytes = this.get(path); return bytes && text.decode(bytes); }
    remove(path) { return this.files.delete(plainPath(path)); }
    /** @returns {Map<string, Uint8Array>} all of them */
    all() { return new Map([...this.files].map(([path, file]) => [path, file.contents()])); }
}

/**
 * The imports of one run, and what it leaves.
 * @param {{args?: string[], files?: Files, env?: Object<string, string>, printed?: MemoryFile}} given printed: where both outputs go
 */
export function wasi({ args = ["program"], files = new Files(), env = {}, printed }) {
    const empty = () => new MemoryFile(new Uint8Array(0), 0), streams = [empty(), printed ?? empty(), printed ?? empty()];
    /** @type {{is: number, file?: MemoryFile, at?: number, flags?: number, folder?: string}[]} */
    const open = [...streams.map((file, i) => ({ file, at: 0, flags: i > 0 ? APPEND : 0, is: CHARACTERS })), { folder: "", is: FOLDER }];
    const strings = (list) => list.map((s) => words.encode(s + "\0"));
    const given = strings(args), environment = strings(Object.entries(env).map(([k, v]) => `${k}=${v}`));
    let memory;
    const view = () => new DataView(memory.buffer), bytes = (at, size) => new Uint8Array(memory.buffer, at, size);

    const sizes = (list) => (count, size) => {
        view().setUint32(count, list.length, true);
        view().setUint32(size, list.reduce((sum, s) => sum + s.length, 0), true);
        return OK;
    };
    const strings_get = (list) => (pointers, at) => {
        for (const s of list) {
            view().setUint32(pointers, at, true);
            bytes(at, s.length).set(s);
            pointers += 4;
            at += s.length;
        }
        return OK;
    };
    const path_of = (folder, at, size) =>
        plainPath(`${open[folder]?.folder ?? ""}/${text.decode(bytes(at, size).slice())}`);
    const buffers = (at, count) => Array.from({ length: count }, (_, i) =>
        bytes(view().getUint32(at + 8 * i, true), view().getUint32(at + 8 * i + 4, true)));
    const opened = (does) => (fd, ...given) => open[fd] ? does(open[fd], ...given) : BAD_FILE;
    const with_file = (does) => opened((it, ...given) => it.file ? does(it, ...given) : BAD_FILE);
    const size_put = (at, size) => { view().setUint32(at, size, true); return OK; };

    function read(file, at, list, count) {
        let moved = 0;
        for (const buffer of buffers(list, count)) {
            const part = file.contents().subarray(at + moved, at + moved + buffer.length);
            buffer.set(part);
            moved += part.length;
        }
        return moved;
    }
    function write(file, at, list, count) {
        let moved = 0;
        for (const buffer of buffers(list, count)) {
            if (!file.write(buffer, at + moved))
                return -1;
            moved += buffer.length;
        }
        return moved;
    }
    function stat(at, kind, number, size) {
        bytes(at, 64).fill(0);
        view().setBigUint64(at, 1n, true);
        view().setBigUint64(at + 8, BigInt(number), true); // each file its own, or clang takes all for one
        view().setUint8(at + 16, kind);
        view().setBigUint64(at + 24, 1n, true);
        view().setBigUint64(at + 32, BigInt(size), true);
        return OK;
    }

    const calls = {
        args_sizes_get: sizes(given), args_get: strings_get(given),
        environ_sizes_get: sizes(environment), environ_get: strings_get(environment),
        proc_exit(status) { throw new Exit(status); },
        random_get(at, size) { // the same in each run
            for (let i = 0, x = 2015; i < size; i++)
                bytes(at + i, 1)[0] = (x = (x * 69069 + 1) >>> 0) >>> 24;
            return OK;
        },
        clock_time_get(_, __, at) { view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true); return OK; },
        poll_oneoff: (_, __, ___, at) => size_put(at, 0),

        fd_prestat_get(fd, at) {
            if (fd !== TOP)
                return BAD_FILE;
            view().setUint32(at, 0, true);
            return size_put(at + 4, 1);
        },
        fd_prestat_dir_name(fd, at) { bytes(at, 1)[0] = "/".charCodeAt(0); return fd === TOP ? OK : BAD_FILE; },
        fd_fdstat_get: opened(({ is, flags = 0 }, at) => {
            bytes(at, 24).fill(0);
            view().setUint8(at, is);
            view().setUint16(at + 2, flags, true);
            view().setBigUint64(at + 8, ~0n, true);
            view().setBigUint64(at + 16, ~0n, true);
            return OK;
        }),
        fd_fdstat_set_flags: opened((it, flags) => { it.flags = flags; return OK; }),
        fd_close(fd) { return open[fd] && delete open[fd] ? OK : BAD_FILE; },
        fd_filestat_get: opened(({ is, file, folder }, at) =>
            file ? stat(at, is, file.number, file.size) : stat(at, FOLDER, files.folders.get(folder), 0)),
        fd_filestat_set_size: with_file(({ file }, size) => { file.resize(Number(size)); return OK; }),
        fd_read: opened((it, list, count, at) => {
            if (!it.file)
                return IS_FOLDER;
            const moved = read(it.file, it.at, list, count);
            it.at += moved;
            return size_put(at, moved);
        }),
        fd_pread: with_file(({ file }, list, count, from, at) => size_put(at, read(file, Number(from), list, count))),
        fd_write: with_file((it, list, count, at) => {
            if (it.flags & APPEND)
                it.at = it.file.size;
            const moved = write(it.file, it.at, list, count);
            if (moved < 0)
                return TOO_BIG;
            it.at += moved;
            return size_put(at, moved);
        }),
        fd_seek: with_file((it, by, whence, at) => {
            if (it.is === CHARACTERS)
                return 70; // ESPIPE
            it.at = Number(by) + [0, it.at, it.file.size][whence];
            view().setBigUint64(at, BigInt(it.at), true);
            return OK;
        }),
        fd_readdir(fd, at, size, cookie, used) {
            const folder = open[fd]?.folder;
            if (folder === undefined)
                return BAD_FILE;
            const inside = folder === "" ? "" : folder + "/";
            /** @type {[number, string][]} */
            const names = [];
            for (const [kind, paths] of /** @type {[number, Map<string, any>][]} */ ([[FOLDER, files.folders], [FILE, files.files]]))
                for (const path of paths.keys())
                    if (path !== "" && path.startsWith(inside) && !path.slice(inside.length).includes("/") && path !== folder)
                        names.push([kind, path.slice(inside.length)]);
            let filled = 0;
            for (let i = Number(cookie); i < names.length && filled < size; i++) {
                const name = words.encode(names[i][1]), entry = new Uint8Array(24 + name.length), put = new DataView(entry.buffer);
                put.setBigUint64(0, BigInt(i + 1), true);
                put.setBigUint64(8, BigInt(i + 2), true);
                put.setUint32(16, name.length, true);
                put.setUint8(20, names[i][0]);
                entry.set(name, 24);
                const part = entry.subarray(0, size - filled);
                bytes(at + filled, part.length).set(part);
                filled += part.length;
            }
            return size_put(used, filled);
        },

        path_open(folder, _, at, size, how, rights, ___, flags, into) {
            const path = path_of(folder, at, size);
            if (files.folders.has(path)) {
                if (how & (OPEN_CREATE | OPEN_EMPTY) && !(how & OPEN_FOLDER))
                    return IS_FOLDER;
                open.push({ folder: path, is: FOLDER });
                return size_put(into, open.length - 1);
            }
            let file = files.files.get(path);
            if (file && how & OPEN_FOLDER)
                return NO_FOLDER;
            if (file && how & OPEN_CREATE && how & OPEN_NEW)
                return EXISTS;
            if (!file && (!(how & OPEN_CREATE) || !files.folders.has(path.split("/").slice(0, -1).join("/"))))
                return NO_ENTRY;
            file ??= files.put(path, new Uint8Array(0));
            if (how & OPEN_EMPTY)
                file.resize(0);
            open.push({ file, at: 0, flags, is: FILE });
            return size_put(into, open.length - 1);
        },
        path_filestat_get(folder, _, at, size, into) {
            const path = path_of(folder, at, size), file = files.files.get(path);
            return file ? stat(into, FILE, file.number, file.size)
        : files.folders.has(path) ? stat(into, FOLDER, files.folders.get(path), 0) : NO_ENTRY;
        },
        path_readlink: () => INVALID,
        path_unlink_file(folder, at, size) { return files.remove(path_of(folder, at, size)) ? OK : NO_ENTRY; },
        path_create_directory(folder, at, size) {
            const path = path_of(folder, at, size);
            if (files.folders.has(path) || files.files.has(path))
                return EXISTS;
            files.addFolder(path);
            return OK;
        },
        path_rename(folder, at, size, other, to, length) {
            const from = path_of(folder, at, size), file = files.files.get(from);
            if (!file)
                return NO_ENTRY;
            files.files.delete(from);
            files.files.set(path_of(other, to, length), file);
            return OK;
        },
    };
    const said = (stream) => text.decode(stream.contents());
    return {
        calls, files, stdout: streams[1], bytes, said: () => said(streams[1]), errors: () => said(streams[2]),
        /** In the instance's memory, up to a 0. */
        string(at) { const all = new Uint8Array(memory.buffer, at); return text.decode(all.slice(0, all.indexOf(0))); },
        /** The calls that a module imports; those that no program here makes are an error number. */
        imports(module) {
            /** @type {Record<string, Function>} */
            const imports = {};
            for (const { module: from, name } of WebAssembly.Module.imports(module))
                if (from === "wasi_snapshot_preview1")
                    imports[name] = calls[name] ?? (() => NOT_THERE);
            return imports;
        },
        /** From now on the calls are about this memory. */
        begin(exports) { memory = exports.memory; },
        /**
         * An instance whose calls are these; book: what else it asks of the page.
         * @returns {any} what it exports
         */
        open(module, book = {}) {
            const { exports } = new WebAssembly.Instance(module, { wasi_snapshot_preview1: this.imports(module), book });
            this.begin(exports);
            return exports;
        },
    };
}

/** A trap in words that do not depend on the browser: what the machine says it was. */
export function trapOf(error) {
    if (error instanceof OutOfSteps)
        return "steps";
    const said = String(error?.message);
    if (error instanceof RangeError || /call stack|recursion/i.test(said))
        return "stack";
    if (!(error instanceof WebAssembly.RuntimeError))
        throw error;
    return /unreachable/i.test(said) ? "unreachable"
    : /divi(de|sion)|remainder/i.test(said) ? "divide"
      : /out of bounds|out-of-bounds/i.test(said) ? "memory" : "other";
}

/** Runs an instance to its end: its exit status. */
export function start(exports) {
    try {
        exports._start();
        return 0;
    } catch (error) {
        if (error instanceof Exit)
            return error.status;
        throw error;
    }
}

/**
 * Runs a program from its start to its end.
 * @param {WebAssembly.Module} module
 * @param {{args?: string[], files?: Files|Map<string, Uint8Array|string>|{}, env?: Object<string, string>,
 *          steps?: number}} given
 *        steps: after this many a module that counts them (chapters/book/instead/steps.c) is ended
 * @returns {{status?: number, trap?: string, error?: Error, stdout: string, stderr: string, files: Files}}
 */
export function run(module, { args, files, env, steps = Infinity } = {}) {
    const system = wasi({ args, files: files instanceof Files ? files : new Files(files), env });
    const result = { files: system.files };
    try {
        const exports = system.open(module, { out_of_steps() { throw new OutOfSteps(); } });
        exports.allow_steps?.(steps);
        result.status = start(exports);
    } catch (error) {
        Object.assign(result, { trap: trapOf(error), error });
    }
    return { ...result, stdout: system.said(), stderr: system.errors() };
}

// ---- the memory of a program that runs again and again ------------------------------------------

// A browser takes a page of memory from the system when it is first written, also if that writes zeros, and never gives it
// back. So pages that are still empty are only read.
export const PAGE = 1 << 16;

/**
 * @param {ArrayBuffer} buffer
 * @param {number} page
 */
export function isEmpty(buffer, page) {
    const words = new Int32Array(buffer, page * PAGE, PAGE / 4);
    for (let i = 0; i < words.length; i += 8)
        if (words[i] | words[i + 1] | words[i + 2] | words[i + 3] | words[i + 4] | words[i + 5] | words[i + 6] | words[i + 7])
            return false;
    return true;
}

/** Zeros from one page to another. A heap grows upward: then, after so many empty pages, there is nothing. */
export function clear(buffer, from, to, most = Infinity) {
    for (let page = from, empty = 0; page < to && empty < most; page++)
        if (isEmpty(buffer, page)) {
            empty++;
        } else {
            new Uint8Array(buffer, page * PAGE, PAGE).fill(0);
            empty = 0;
        }
}
