// archive.test.mjs - the page's archive of answers: the grader reads it, and the page reads what others pack.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { answersIn, makeZip, readZip } from "../../../chapters/book/page/answers.js";

const folder = mkdtempSync(join(tmpdir(), "book-archive-"));
process.on("exit", () => rmSync(folder, { recursive: true, force: true }));
const bytesOf = (text) => new TextEncoder().encode(text);
const python = (code, ...args) => execFileSync("python3", ["-B", "-c", code, ...args], { encoding: "utf8", env: { ...process.env, PYTHONPATH: "tests" } });
const file = (name, bytes) => new File([bytes], name);
const stems = ["01-corners", "05-quadratic"];
const texts = { "01-corners.c": "// größer als 1, \u2212 und so weiter\nint x;\n", "05-quadratic.c": "" };

test("the grader reads each answer byte for byte", async () => {
    const path = join(folder, "submission.zip");
    writeFileSync(path, await makeZip(Object.entries(texts).map(([name, text]) => ({ name, bytes: bytesOf(text) }))));
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
    writeFileSync(path, await makeZip(Object.entries(texts).map(([name, text]) => ({ name, bytes: bytesOf(text) })), new Date(2026, 10, 22, 21, 8, 30)));
    const said = python("import sys, zipfile\nz = zipfile.ZipFile(sys.argv[1])\nprint(z.testzip(), [i.date_time for i in z.infolist()][0], oct(z.infolist()[0].external_attr >> 16))", path);
    assert.equal(said.trim(), "None (2026, 11, 22, 21, 8, 30) 0o100644");
});

test("an archive comes back as it went", async () => {
    const found = await answersIn([file("submission.zip", await makeZip(Object.entries(texts).map(([name, text]) => ({ name, bytes: bytesOf(text) }))))], stems);
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
