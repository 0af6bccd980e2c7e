// answers.test.mjs - what is kept of a student's answers, in browsers that keep and in browsers that do not; and the archive of
// them: the grader reads the page's, and the page reads what others pack.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { answersIn, makeZip, nameOfText, openAnswers, readZip } from "../../../chapters/book/page/answers.js";

// ---- in the browser ---------------------------------------------------------------------------------

/** localStorage as far as the page uses it; room counts characters. */
function storageOf(room = Infinity) {
    const kept = new Map();
    return {
        get length() { return kept.size; },
        getItem: (name) => kept.get(name) ?? null,
        setItem(name, value) {
            const used = [...kept].reduce((sum, [key, text]) => sum + (key === name ? 0 : key.length + text.length), name.length + value.length);
            if (used > room)
                throw new DOMException("full", "QuotaExceededError");
            kept.set(name, value);
        },
    };
}
const open = (storage, folder = "/course/") => {
    const trouble = [];
    return { trouble, answers: openAnswers({ storage, folder, onTrouble: (words) => trouble.push(words) }) };
};

test("another page of the same site reads what was saved; a site in another folder does not", () => {
    const storage = storageOf();
    open(storage).answers.save("05-quadratic", "mine");
    assert.equal(open(storage).answers.text("05-quadratic"), "mine");
    assert.equal(open(storage, "/other/").answers.text("05-quadratic"), null);
});

test("a reset can be undone, also after many", () => {
    const { answers } = open(storageOf());
    for (let i = 0; i < 50; i++) {
        answers.save("05-quadratic", `version ${i}`);
        answers.keepVersion("05-quadratic", "before a reset");
        answers.save("05-quadratic", "blank");
    }
    assert.equal(answers.takeVersion("05-quadratic").text, "version 49");
    assert.equal(answers.takeVersion("05-quadratic").text, "version 48");
    assert.ok(answers.versions("05-quadratic").length < 20);
});

test("a verdict counts for the text that was judged, and for no other", () => {
    const { answers } = open(storageOf());
    answers.save("05-quadratic", "right");
    answers.saveVerdict("05-quadratic", { of: nameOfText("right"), right: 6, total: 6, done: true });
    assert.equal(answers.verdict("05-quadratic").right, 6);
    answers.save("05-quadratic", "changed");
    assert.equal(answers.verdict("05-quadratic"), null);
});

test("without storage the page still knows the answers, and says that they will be lost", () => {
    const { answers, trouble } = open(null);
    assert.equal(answers.save("05-quadratic", "mine"), false);
    assert.equal(answers.text("05-quadratic"), "mine");
    assert.match(trouble[0], /does not save your answers/);
});

test("with a full storage the page has what was typed last, not what was saved before it was full", () => {
    const { answers, trouble } = open(storageOf(200));
    answers.save("05-quadratic", "short");
    answers.save("05-quadratic", "x".repeat(500));
    assert.equal(answers.text("05-quadratic"), "x".repeat(500));
    assert.equal(answers.isKept("05-quadratic"), false);
    answers.save("05-quadratic", "short again");
    assert.deepEqual([answers.isKept("05-quadratic"), trouble.at(-1)], [true, ""]);
});

test("with a full storage the page says so, and keeps the text until it is closed", () => {
    const { answers, trouble } = open(storageOf(200));
    assert.equal(answers.save("01-corners", "short"), true);
    assert.equal(answers.save("05-quadratic", "x".repeat(300)), false);
    assert.match(trouble[0], /no more room/);
    assert.equal(answers.text("05-quadratic").length, 300);
});

test("what others wrote into the storage is no obstacle", () => {
    const storage = storageOf(), { answers } = open(storage);
    storage.setItem("ray-casting /course/ 05-quadratic versions", "{not json");
    storage.setItem("ray-casting /course/ 05-quadratic verdict", "7");
    assert.deepEqual(answers.versions("05-quadratic"), []);
    assert.equal(answers.verdict("05-quadratic"), null);
});

// ---- the archive ------------------------------------------------------------------------------------

const folder = mkdtempSync(join(tmpdir(), "book-archive-"));
process.on("exit", () => rmSync(folder, { recursive: true, force: true }));
const bytesOf = (text) => new TextEncoder().encode(text);
const python = (code, ...args) => execFileSync("python3", ["-B", "-c", code, ...args], { encoding: "utf8", cwd: new URL("../../../", import.meta.url), env: { ...process.env, PYTHONPATH: "tests" } });
const file = (name, bytes) => new File([bytes], name);
const stems = ["01-corners", "05-quadratic"];
const texts = { "01-corners.c": "// größer als 1, \u2212 und so weiter\nint x;\n", "05-quadratic.c": "" };
const packed = (...date) => makeZip(Object.entries(texts).map(([name, text]) => ({ name, bytes: bytesOf(text) })), ...date);

test("the grader reads each answer byte for byte", async () => {
    const path = join(folder, "submission.zip");
    writeFileSync(path, await packed());
    const found = python(`
import json, sys
from grade.collect import answers, archives
search = answers.search_for(${JSON.stringify(stems)})
archives.look(search, sys.argv[1].encode())
print(json.dumps({stem: (each.state, each.text.decode()) for stem, each in answers.all_of(search).answers.items()}))`, path);
    assert.deepEqual(JSON.parse(found), { "01-corners": ["found", texts["01-corners.c"]], "05-quadratic": ["found", ""] });
});

test("Python finds nothing wrong with the archive", async () => {
    const path = join(folder, "tested.zip");
    writeFileSync(path, await packed(new Date(2026, 10, 22, 21, 8, 30)));
    const said = python("import sys, zipfile\nz = zipfile.ZipFile(sys.argv[1])\nprint(z.testzip(), [i.date_time for i in z.infolist()][0], oct(z.infolist()[0].external_attr >> 16))", path);
    assert.equal(said.trim(), "None (2026, 11, 22, 21, 8, 30) 0o100644");
});

test("an archive comes back as it went", async () => {
    const found = await answersIn([file("submission.zip", await packed())], stems);
    assert.deepEqual(Object.fromEntries(found), { "01-corners": texts["01-corners.c"], "05-quadratic": "" });
});

test("a compressed archive of a whole handout gives its exercises only", async () => {
    const path = join(folder, "handout.zip");
    python(`
import sys, zipfile
with zipfile.ZipFile(sys.argv[1], "w", zipfile.ZIP_DEFLATED) as z:
    z.writestr("ray-casting/exercises/05-quadratic.c", "mine\\r\\n" * 100)
    z.writestr("ray-casting/tests/blanks/05-quadratic.c", "blank")
    z.writestr("__MACOSX/05-quadratic.c", "junk")`, path);
    const found = await answersIn([file("handout.zip", readFileSync(path))], stems);
    assert.deepEqual(Object.fromEntries(found), { "05-quadratic": "mine\n".repeat(100) });
});

test("loose files, also second downloads, are read; two that differ are refused", async () => {
    assert.deepEqual(Object.fromEntries(await answersIn([file("05-quadratic (2).c", "a"), file("01-corners.c", "b"), file("notes.c", "c")], stems)),
        { "05-quadratic": "a", "01-corners": "b" });
    await assert.rejects(answersIn([file("05-quadratic (2).c", "a"), file("05-quadratic.c", "b")], stems), /two different files 05-quadratic.c/);
});

test("what is no archive, and what is damaged, is refused in words", async () => {
    await assert.rejects(readZip(bytesOf("x".repeat(100))), /not a zip archive/);
    const zip = await makeZip([{ name: "05-quadratic.c", bytes: bytesOf("int main") }]);
    await assert.rejects(readZip(zip.subarray(0, zip.length - 1)), /this archive is damaged/);
});
