// judge.js - the verdict on an answer, as 'make exercises' prints it.
//
// It is the same C: tests/course/course.c and tests/judge/judge.c, each a WebAssembly program. This
// module is what the system is to them: it starts one program for another, and carries the bytes
// between the judge and the answer, which are two instances. Nothing of a verdict is decided here.
import { hideHelpers } from "./tools.js";
import { Exit, Files, OutOfSteps, run, start as startProgram, trapOf, wasi } from "./wasi.js";

const text = new TextDecoder(), STEPS_PER_SECOND = 30e6;

// As page.h numbers them.
const GOES_ON = 0, EXITED = 1, STEPS = 2, PRINTED = 7;
const TRAPS = { steps: STEPS, unreachable: 3, divide: 4, stack: 5, memory: 6, other: 6 };

class PrintedTooMuch extends Error {}
const LEFT = Symbol("a test was left");
/** A picture waits for a link, which may take a while. */
class NeedsLink extends Error {
    constructor(words) { super("a link"); this.words = words; }
}

/** Bytes on their way from one instance to the other. */
class Pipe {
    constructor() { this.parts = []; this.read = 0; this.size = 0; }
    put(bytes) { this.parts.push(bytes.slice()); this.size += bytes.length; }
    get(into) {
        for (let at = 0; at < into.length;) {
            const part = this.parts[0].subarray(this.read, this.read + into.length - at);
            into.set(part, at);
            at += part.length;
            this.read += part.length;
            if (this.read === this.parts[0].length) { this.parts.shift(); this.read = 0; }
        }
        this.size -= into.length;
    }
}

/** An answer in an instance of its own, until it ends. */
class Answer {
    constructor(module, lent, printed, serve) {
        this.calls = new Pipe();
        this.answers = new Pipe();
        this.end = GOES_ON;
        this.isCalled = false;
        this.status = 0;
        const system = wasi({ env: { LENT: lent }, printed });
        this.exports = system.open(module, {
            call_put: (at, size) => this.answers.put(system.bytes(at, size)),
            call_get: (at, size) => {
                if (this.calls.size < size && !(this.isCalled && serve()))
                    return 0; // it waits for what is lent
                this.calls.get(system.bytes(at, size));
                return 1;
            },
            out_of_steps() { throw new OutOfSteps(); },
        });
        this.exports._initialize();
    }
    get steps() { return this.exports.steps_so_far?.() ?? 0; }
    /** Until it has answered, or ended. */
    answer() {
        try {
            this.exports.answer();
        } catch (error) {
            if (error instanceof Exit) { this.end = EXITED; this.status = error.status; return; }
            if (error instanceof PrintedTooMuch) { this.end = PRINTED; return; }
            const trap = trapOf(error);
            // The stack grows down to address 0; below that is no memory.
            const overflow = trap === "memory" && this.exports.__stack_pointer.value < 0;
            this.end = overflow ? TRAPS.stack : TRAPS[trap];
        }
    }
}

/** The judge's program: its tests, and the answer that it calls. */
function runJudge(module, words, files, answerOf) {
    const system = wasi({ args: words, files, env: {} });
    let answer, steps = 0, most = Infinity;
    const bye = () => { steps += answer?.steps ?? 0; answer = undefined; };
    const exports = system.open(module, {
        answer_start(program, mostSteps) {
            most = mostSteps;
            if (answer)
                return;
            const printed = files.files.get("printed"), write = printed.write;
            printed.write = (bytes, at) => {
                if (at + bytes.length > 1 << 20)
                    throw new PrintedTooMuch(); return write.call(printed, bytes, at);
            };
            const { module, lent } = answerOf(system.string(program));
            answer = new Answer(module, lent, printed, () => exports.serve());
        },
        answer_stop() { const status = answer?.status ?? 0; bye(); return status; },
        answer_steps: () => steps + (answer?.steps ?? 0),
        answer_put(at, size) { answer.calls.put(system.bytes(at, size)); },
        answer_get(at, size) {
            if (answer.answers.size < size && answer.end === GOES_ON && !answer.isCalled) {
                answer.isCalled = true;
                answer.exports.allow_steps?.(most);
                answer.answer();
                answer.isCalled = false;
            }
            if (answer.answers.size < size)
                return answer.end === GOES_ON ? EXITED : answer.end;
            answer.answers.get(system.bytes(at, size));
            return GOES_ON;
        },
        guard() {
            const stack = exports.__stack_pointer.value;
            try {
                exports.guarded();
                return 1;
            } catch (error) {
                if (error !== LEFT)
                    throw error;
                exports.__stack_pointer.value = stack;
                return 0;
            }
        },
        leave() { throw LEFT; },
    });
    const status = startProgram(exports);
    files.remove("printed");
    return { status, said: system.said() + system.errors() };
}

/** The parts that course writes for a page (tests/course/page.h). */
export const partsOf = (written) => written.split("\x1e").slice(0, -1).map((part) => part.split("\x1f")).map(([kind, label, words]) => ({ kind, label, words }));

/**
 * Judges the answers of one student.
 * @param {{modules: {course: WebAssembly.Module, judge: WebAssembly.Module},
 *          files: Map<string, Uint8Array|string>,
 *          compile: Function, link?: Function}} given
 *        files: those of build/book/tree. compile and link: the commands of its plan; each is given
 *        the words of the command and all files, puts its output there, and returns
 *        {status, said, module?}; without link, or if it returns nothing, a picture waits for draw()
 */
export function createJudge({ modules, files: given, compile, link }) {
    const files = new Files(given);
    const made = new Map(); // what link has made: {module, lent}
    let links = new Map(); // of pictures, by the words of their commands
    let compiled = {}; // by stem, if the answers were compiled before

    const option = (words, name) => words[words.indexOf(name) + 1];
    const stemOf = (path) => path.split("/").pop().replace(/\.c$/, "");
    const programs = {
        compile(words) {
            const before = compiled[stemOf(words.at(-1))];
            if (!before)
                return compile(words, files);
            if (!before.module && before.stage !== "link")
                return { status: before.status || 1, said: before.messages };
            files.put(option(words, "-o"), before.object ?? files.get(words.at(-1)));
            return { status: 0, said: before.stage === "link" ? "" : before.messages ?? "" };
        },
        link(words) {
            const output = option(words, "-o"), lent = words.filter((w) => w.startsWith("--lend=")).map((w) => w.slice(7)).join(" ");
            const isAnswer = /\/(answering|alone)$/.test(output);
            // Linked before: by the page, or with nothing lent.
            const before = isAnswer && (compiled[output.split("/").at(-2)] ?? (lent && made.get(output.replace(/alone$/, "answering"))));
            const linked = !before ? link?.(words.filter((w) => !w.startsWith("--lend=")), files) ?? links.get(words.join(" "))
                : before.module ? { status: 0, said: "", module: before.module } : { status: before.status || 1, said: before.messages };
            if (!linked)
                throw new NeedsLink(words);
            if (linked.module)
                made.set(output, { module: linked.module, lent });
            return linked;
        },
        hide(words) { // only in a handout, where answers of earlier chapters are linked
            const kept = new Set(files.text("build/exercises.names").split("\n"));
            files.put(words[1], hideHelpers(files.get(words[1]), kept));
            return { status: 0, said: "" };
        },
        judge: (words) => runJudge(modules.judge, words, files, (path) => made.get(path)),
        draw: () => ({ status: 0, said: "" }), // the page draws figures by itself
    };
    function start(words, output, seconds) {
        const name = words[0], program = made.get(name)?.module;
        let result;
        if (programs[name])
            result = programs[name](words);
        else if (program) {
            const ran = run(program, { args: words, files, steps: seconds ? seconds * STEPS_PER_SECOND : undefined });
            result = { status: ran.trap ? 128 + 6 : ran.status, said: ran.stdout + ran.stderr };
        } else
            result = { status: 127, said: `${name}: there is no such program\n` };
        if (output && output !== "/dev/null")
            files.put(output, result.said ?? "");
        return result.status;
    }
    /** Runs course (tests/course/course.c). */
    function course(what, stems, env = {}) {
        const system = wasi({ args: ["course", what, "plan", ...stems], files, env: { TERM: "dumb", ...env } });
        const exports = system.open(modules.course, {
            program_start(at, size, output, seconds) {
                const words = text.decode(system.bytes(at, size).slice()).split("\0").slice(0, -1);
                return start(words, output ? system.string(output) : null, seconds);
            },
            program_exists: (name) => Number(system.string(name) === "gnuplot"),
        });
        let status = 0, needs;
        const marks = new Set(marksNow());
        try {
            status = startProgram(exports);
        } catch (error) {
            if (!(error instanceof NeedsLink))
                throw error;
            needs = error.words;
            for (const mark of marksNow())
                marks.has(mark) || files.remove(mark); // it will be shown again
        }
        return { status, needs, text: system.said(), errors: system.errors() };
    }
    // Of pictures that were shown, and of rewards.
    const marksNow = () => [...files.files.keys()].filter((path) => /\.(drawn|rewarded)$/.test(path));
    function take({ sources = {}, compiled: before = {} }) {
        for (const [stem, source] of Object.entries(sources))
            files.put(`exercises/${stem}.c`, source);
        compiled = before;
    }
    return {
        files,
        /**
     * @param {{stem: string, sources?: Object<string, string>, compiled?: Object<string, object>,
     *          web?: boolean}} given  compiled: of each stem, what compiler.js returned; web: parts of a verdict (partsOf), not text
     * @returns {{text: string, status: number, record: string, needs?: string[]}} needs: there is more to draw (draw)
     */
        judge({ stem, web, ...given }) {
            take(given);
            return { ...course("exercises", [stem], web ? { WEB: "1" } : {}), record: files.text(`build/exercises/verdict/${stem}.record`) ?? "" };
        },
        /**
     * The same with the pictures that the answer draws: if judge() returned 'needs', they wait for links.
     * @param {(words: string[], files: Files) => Promise<{status: number, module?: WebAssembly.Module}>} linkPicture
     */
        async draw(given, linkPicture) {
            const mine = new Map(); // another answer may be judged meanwhile
            for (;;) {
                links = mine;
                const shown = this.judge(given);
                links = new Map();
                if (!shown.needs)
                    return shown;
                mine.set(shown.needs.join(" "), await linkPicture(shown.needs, files));
            }
        },
        /** One hint more, as parts; a line for each function, as 'make status'. */
        hint(stem, given = {}) { take(given); return course("hint", [stem], { WEB: "1" }); },
        status(stems) { return course("status", stems); },
    };
}
