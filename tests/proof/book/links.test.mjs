// links.test.mjs - figures, slides and exercises link to each other, and every link leads to something.
//
// Usage: node links.test.mjs, after make book
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";

const pages = new Map(readdirSync("build/book").filter((name) => name.endsWith(".html")).map((name) => [name, readFileSync(`build/book/${name}`, "utf8")]));
const all = (text, pattern) => [...text.matchAll(pattern)].map(([, found]) => found);
const sections = (page) => pages.get(page).split("<section ").slice(1);
const linksOf = (text) => all(text, / href="([^"]*)"/g);

let count = 0;
for (const [name, html] of pages) {
    for (const [page, id] of linksOf(html).filter((link) => /^[\w-]*(\.html)?#./.test(link)).map((link) => link.split("#"))) {
        // page/mistakes.js finds a chapter by its stem.
        assert.ok(new RegExp(` (id|data-stem)="${decodeURIComponent(id)}"`).test(pages.get(page || name)), `${name}: nothing is at ${page}#${id}`);
        count++;
    }
}

// In the order of the lecture, at its first step, with its address.
const inLecture = [...new Set(all(pages.get("lecture.html"), / data-figure="([^"]*)"/g))];
const figures = sections("figures.html").filter((each) => each.includes(" data-figure="));
const names = figures.map((each) => all(each, / data-figure="([^"]*)"/g)[0]);
assert.deepEqual(names.filter((name) => inLecture.includes(name)), inLecture, "figures.html is in the lecture's order");
figures.forEach((figure, i) => {
    assert.match(figure, new RegExp(`^id="${names[i]}".*href="#${names[i]}".* data-step="1"`, "s"), `${names[i]} has an address, and is at its first step`);
    const stem = all(figure, / data-stem="([^"]*)"/g)[0], links = linksOf(figure);
    assert.ok(links.includes(`${stem}.html#exercise`), `${names[i]}: a link to its exercise`);
    assert.equal(links.some((link) => link.startsWith("lecture.html#")), inLecture.includes(names[i]), `${names[i]}: a link to its slide`);
});

const slides = sections("lecture.html");
for (const slide of slides) {
    const [id] = all(slide, /^[^>]* id="([^"]*)"/g), figure = all(slide, / data-figure="([^"]*)"/g);
    assert.deepEqual(all(slide, / href="figures.html#([^"]*)"/g), figure, `${id}: a link to its figure`);
    const [exercise] = all(slide, />Exercise (\d\d):/g);
    assert.ok(!exercise || linksOf(slide).some((link) => link.startsWith(`${exercise}-`)), `${id}: a link to exercise ${exercise}`);
}
for (const stem of all([...pages.keys()].join("\n"), /^(\d\d-.*)\.html$/gm)) {
    const [name] = all(pages.get(`${stem}.html`), / href="lecture.html#([^"]*)"/g);
    assert.ok(slides.some((slide) => slide.includes(` id="${name}"`) && slide.includes(`href="${stem}.html#exercise"`)), `${stem}: a link to its slides, and back`);
}
console.log(`links: ${count} lead somewhere; ${names.length} figures, ${slides.length} pages of slides`);
