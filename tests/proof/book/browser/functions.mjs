// functions.mjs - a wrong answer to each function, in a real browser: the record is the one of the same programs in node
// (verdicts.mjs compares those with the terminal), and the page shows all that the judge says. Engines of JavaScript
// differ in how a program ends, and in little else.
//
// Usage: BROWSER=chromium|firefox CHAPTERS=01,05 node functions.mjs SITE
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import test from "node:test";
import { partsOf } from "../../../../chapters/book/judge.js";
import { openSite } from "../in_node.mjs";
import { begin, replaceText, waitFor } from "../site.mjs";

const chapters = process.env.CHAPTERS?.split(",");
const stems = readdirSync("solutions").filter((name) => /^0[1-7]-.*\.c$/.test(name) && (!chapters || chapters.includes(name.slice(0, 2))))
    .map((name) => name.slice(0, -2)).sort();

// ---- in node ---------------------------------------------------------------------------------------

const { tools, newJudge } = await openSite(process.argv[2]), sources = {}, judge = newJudge();

async function verdictHere(stem, text) {
    sources[stem] = text;
    const verdict = await judge.draw({ stem, sources, web: true }, async (words, all) => tools.link(words, all));
    return { record: verdict.record, words: partsOf(verdict.text).filter(({ kind, words }) => !["hint", "compiler"].includes(kind) && !/~.*, /.test(words)).map(({ words }) => words) };
}

// ---- wrong answers -----------------------------------------------------------------------------------

const opposite = { "+": "-", "-": "+", "*": "/", "/": "*", "<": ">", ">": "<" };
/** The solution with another operator in one function; if that has none, it is not answered. */
function wrong(solution, name) {
    const begin = solution.search(new RegExp(`^\\w.*\\b${name}\\([^;]*?\\)\\n\\{`, "m")), end = solution.indexOf("\n}", begin);
    const found = /^ (?!.*\/\/).*? ([-+*/<>]) /m.exec(begin < 0 ? "" : solution.slice(begin, end));
    if (!found)
        return solution.slice(0, begin) + solution.slice(begin).replace(/\/\/~ /, "");
    const at = begin + found.index + found[0].length - 2;
    return solution.slice(0, at) + opposite[solution[at]] + solution.slice(at + 1);
}

const { openPage } = await begin();
test("a wrong answer to each function has the verdict of node", async () => {
    const tab = await openPage("index.html");
    for (const stem of stems) {
        const solution = readFileSync(`solutions/${stem}.c`, "utf8");
        const names = readFileSync(`build/answer_names/${stem}`, "utf8").trim().split("\n").map((line) => line.split(" ")[0]);
        await tab.visit(`${stem}.html`);
        for (const name of names) {
            const text = wrong(solution, name);
            const wanted = await verdictHere(stem, text);
            await replaceText(tab, text, { judge: true });
            await waitFor(`a verdict on ${name}`, () => tab.evaluate(() => document.querySelector("#verdict[data-result]") !== null &&
                !document.querySelector("#verdict").classList.contains("old") && /judged/.test(document.querySelector("#state").textContent))); // with its pictures
            assert.equal(await tab.evaluate((key) => localStorage.getItem(key), `ray-casting /course/ ${stem} record`), wanted.record, `${stem}, ${name}`);
            const plain = (words) => words.replace(/[\s~\u00a0]/g, "").toLowerCase(), shown = plain(await tab.text("#verdict"));
            assert.deepEqual(wanted.words.filter((words) => !shown.includes(plain(words))), [], `${stem}, ${name}: all that the judge says is shown`);
        }
    }
    assert.deepEqual(tab.faults, []);
});
