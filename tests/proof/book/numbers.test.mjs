// numbers.test.mjs - the numbers in a lesson for the example of a figure are those that make lessons writes if
// chapters/example.h has that example: for two other examples, all numbers of all lessons.
//
// Usage: node numbers.test.mjs, after make book
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { lessonNumbers } from "../../../chapters/book/figure.js";

const stems = [...readFileSync("chapters/lessons/lines.txt", "utf8").matchAll(/^= (.*)/gm)].map(([, stem]) => stem);

// The options of a figure, and what chapters/example.h would have.
const camera = (eye, distance, width, height) => ({ eye, distance, width, height });
const examples = [
    { camera: camera("1,0.5,-3", "2", "3", "1.5"), place: ["0.25", "0.8"], pixel: "100,50", origin: "-5,0.5,1", direction: "1,0.1,-0.25", center: "0.5,0.25,0", radius: "2" },
    { camera: camera("-2,7,0.125", "0.75", "1", "2"), place: ["1", "0"], pixel: "639,0", origin: "3,3,3", direction: "-1,-1,-1", center: "0,0,0.5", radius: "0.75" },
];
const optionsOf = (stem, { camera: its, place: [s, t], pixel, origin, direction, center, radius }) => ({
    "01-corners": { ...its, s, t }, "02-cameras": its, "03-screen": { pixel }, "04-pixel-ray": { ...its, pixel },
    "05-quadratic": { origin, direction, center, radius } })[stem];

function headerOf(options) {
    const camera = { eye: "EYE", distance: "DISTANCE", width: "WIDTH", height: "HEIGHT" };
    const names = { ...camera, pixel: "POINT", origin: "RAY_ORIGIN", direction: "RAY_DIRECTION", center: "CENTER", radius: "RADIUS" };
    const values = { ...options, ...(options.s ? { PLACE: `${options.s}, ${options.t}` } : {}) };
    let header = readFileSync("chapters/example.h", "utf8");
    for (const [option, value] of Object.entries(values))
        header = header.replace(new RegExp(`^(#define EXAMPLE_${names[option] ?? option}) .*$`, "m"), `$1 ${value}`);
    return header;
}

/** The numbers by their names, from a lesson in which they are marked. */
const numbersIn = (lesson) => Object.fromEntries([...lesson.matchAll(/\uE000(\w+)\uE001([^\uE002]*)\uE002/g)].map(([, name, text]) => [name, text]));

const scratch = mkdtempSync(join(tmpdir(), "numbers-"));
let count = 0, others = 0;
try {
    mkdirSync(join(scratch, "chapters"));
    const program = new WebAssembly.Module(readFileSync("build/book/programs/numbers.wasm"));
    for (const stem of stems) {
        const lecture = numbersIn(readFileSync(`build/lessons/${stem}.marked.md`, "utf8"));
        assert.deepEqual(lessonNumbers(program, "any", {}), {}, `${stem}: no options, no other number`);
        for (const options of examples.map((each) => optionsOf(stem, each))) {
            writeFileSync(join(scratch, "chapters/example.h"), headerOf(options));
            execFileSync("cc", ["-std=c11", "-D_DEFAULT_SOURCE", "-ffp-contract=off", "-Wno-psabi", `-I${scratch}`, "-I.",
                "-o", join(scratch, "numbers"), "chapters/shared/example.c",
                "build/chapters/lessons/print_numbers.o", "build/chapters/lessons/numbers.o", "build/chapters/02-cameras/forms.o",
                ...stems.map((each) => `build/solutions/${each}.o`), "build/chapters/shared.a", "build/common.a", "-lm"]);
            const ofLesson = (numbers) => Object.fromEntries(Object.entries(numbers).filter(([name]) => name in lecture));
            const made = ofLesson(JSON.parse(execFileSync(join(scratch, "numbers"), { encoding: "utf8" })));
            const followed = ofLesson(lessonNumbers(program, "any", options));
            assert.deepEqual({ ...lecture, ...followed }, made, `${stem}: ${JSON.stringify(options)}`);
            assert.ok(Object.entries(followed).every(([name, text]) => text !== lecture[name]), `${stem}: only what differs`);
            count += Object.keys(made).length;
            others += Object.keys(followed).length;
        }
        assert.throws(() => lessonNumbers(program, "any", { radius: "much" }), /--radius/);
    }
    assert.ok(others > 100, `${others} numbers are others`);

    // A ray that is dragged past the sphere has no root, and the pixel of a point is the one that it is in.
    const numbersOf = (options, figure = "any") => lessonNumbers(program, figure, options);
    const { t0, t1, D } = numbersOf({ origin: "-4,2,0" });
    assert.ok(t0 === "none" && t1 === "none" && D.startsWith("−"));
    const { x, column = "300", row, pixel_center: center } = numbersOf({ point: "300.25,12.5" });
    assert.deepEqual([x, column, row, center], ["300.25", "300", "12", "(300.5, 12.5)"]);

    // This figure has a screen of its own.
    assert.deepEqual(numbersOf({ pixel: "1,2" }, "pixel-grid"), {});

    // Each number has its place in the page, in a formula twice; what is for a terminal is not there.
    if (existsSync("build/book/05-quadratic.html"))
        for (const stem of stems) {
            const page = readFileSync(`build/book/${stem}.html`, "utf8"), lesson = readFileSync(`build/lessons/${stem}.marked.md`, "utf8");
            const lecture = numbersIn(lesson.replace(/<!-- terminal -->.*?<!-- \/terminal -->/gs, ""));
            for (const name of Object.keys(lecture))
                assert.ok(page.includes(`data-number="${name}"`), `${stem}: ${name} in the page`);
            assert.ok(!/[\uE000-\uE002]|number:/.test(page), `${stem}: a mark is left`);
        }
} finally {
    rmSync(scratch, { recursive: true });
}
console.log(`numbers: ${count} in lessons of two other examples, ${others} of them not the lecture's`);
