// answers.test.mjs - what is kept of a student's answers, in browsers that keep and in browsers that do not.
import assert from "node:assert/strict";
import test from "node:test";
import { nameOfText, openAnswers } from "../../../chapters/book/page/answers.js";

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
