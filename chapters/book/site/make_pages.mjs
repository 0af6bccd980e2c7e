// make_pages.mjs - writes the pages of the site: start, chapters, figures, contracts. Runs when the site is built.
//
// Usage: node make_pages.mjs ROOT SITE EXERCISES.txt LESSONS DRAWN LECTURE FILMS [HAND-IN-ADDRESS [ADDRESS]]
// ROOT is the folder of the toolkit (or of a handout), EXERCISES.txt is what list_exercises prints,
// LESSONS the folder with the lessons whose numbers are marked, DRAWN that of the figures: NAME/NAME[-4x3][-stepN][-dark].svg.
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { lecturePage, typeset, withCodes } from "./lecture.mjs";
import { coloredC, escape, figure, lessonHtml } from "./lesson.mjs";

const [root, site, exercisesFile, lessonsFolder, drawnFolder, lectureFile, filmsFolder, handIn = "", givenAddress = ""] = process.argv.slice(2);
const address = givenAddress && givenAddress.replace(/\/*$/, "/"); // of the site, if make was told it
const isHandout = !existsSync(join(root, "solutions")); // its figures stay static: their programs hold answers
const used = new Set();
const packageFolder = (name) => dirname(createRequire(import.meta.url).resolve(`${name}/package.json`));

// ---- what there is ------------------------------------------------------------------------------

const stems = readdirSync(join(root, "exercises")).filter((name) => /^\d\d-.*\.c$/.test(name)).sort().map((name) => name.slice(0, -2));
const functions = {};
for (const line of readFileSync(exercisesFile, "utf8").split("\n").filter(Boolean)) {
    const [stem, name] = line.split("\t");
    (functions[stem] ??= []).push(name);
}

/** The page that belongs to chapter 08. */
const ENGINES = "chapters/08-fast/engines.md";
const listings = new Set();
/** Which page of the site shows a file of the toolkit. */
function pageOf(path) {
    const stem = /^chapters\/([^/]+)\/README\.md$/.exec(path)?.[1];
    if (stem && stems.includes(stem))
        return `${stem}.html`;
    if (path === "README.md")
        return "index.html";
    if (path === "exercises/optional/README.md")
        return "optional.html";
    if (path === ENGINES)
        return "engines.html";
    if (/\.(png|svg)$/.test(path)) {
        used.add(path);
        return path;
    }
    if (/^(exercises|common)\/[^/]+\.h$/.test(path) && existsSync(join(root, path))) {
        listings.add(path);
        return `listings/${path}.html`;
    }
    return null;
}

// ---- the frame of every page --------------------------------------------------------------------

// Nothing from anywhere else, and no script but the site's own. gnuplot's SVGs and KaTeX's formulas have style
// attributes; style elements are not allowed.
const POLICY = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; style-src-attr 'unsafe-inline'; " +
    "img-src 'self' data: blob:; font-src 'self'; connect-src 'self'; worker-src 'self'; manifest-src 'self'; base-uri 'none'; form-action 'none'";

const lessons = Object.fromEntries(stems.map((stem) => [stem, lessonHtml({
    root, path: `chapters/${stem}/README.md`, marked: join(lessonsFolder, `${stem}.marked.md`), pageOf, used,
})]));
const countOf = (stem) => `${functions[stem].length} function${functions[stem].length === 1 ? "" : "s"}`;
const shortTitle = (stem) => lessons[stem].title.replace(/^\d\d /, "");

const ABOUT = "Write a ray caster in C, one function at a time: short lessons with figures that move, and a judge that says what is wrong and why. In the browser.";

/** Without these a text would be laid out twice. */
const fonts = (mathematics) => ["source-serif-400-normal", "source-serif-600-normal", ...(mathematics ? ["KaTeX_Main-Regular", "KaTeX_Math-Italic"] : [])];

/** For browsers, search engines, and who is sent a link; more: what this page loads. */
const head = ({ title, attributes, about = ABOUT, up = "", policy = POLICY, more }) => `<!DOCTYPE html>
<html lang="en"${attributes}${isHandout ? ' data-figures="static"' : ""}>
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1, interactive-widget=resizes-content">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="color-scheme" content="light dark">
<title>${escape(title)}</title>
<meta name="description" content="${about}">
<meta property="og:title" content="${escape(title)}">
<meta property="og:description" content="${about}">
<meta property="og:image" content="${address || up}share.png">
<meta name="twitter:card" content="summary_large_image">
<link rel="icon" href="${up}icon.svg" type="image/svg+xml">
<link rel="manifest" href="${up}course.webmanifest">
<link rel="stylesheet" href="${up}style.css">
${more}<script src="${up}early.js"></script>`;

function frame({ title, up = "", kind, stem = "", main, mathematics = false }) {
    const chapters = (asList) => stems.map((other) => `<li data-stem="${other}"><a href="${up}${other}.html"${other === stem ? ' aria-current="page"' : ""}` + (asList
        ? `><span class="number">${other.slice(0, 2)}</span> <span>${escape(shortTitle(other))}</span> <span class="done">${countOf(other)}</span></a></li>`
        : ` title="${escape(shortTitle(other))}"><span class="number">${other.slice(0, 2)}</span><span class="aloud"> ${escape(shortTitle(other))}</span></a></li>`)).join("");
    const about = escape(stem ? `You write ${lessons[stem].gives.replaceAll("`", "")}.` : ABOUT);
    const more = fonts(mathematics).map((font) => `<link rel="preload" href="${up}fonts/${font}.woff2" as="font" type="font/woff2" crossorigin>\n`).join("") +
        (mathematics ? `<link rel="stylesheet" href="${up}mathematics.css">\n` : "");
    return `${head({ title, attributes: ` data-up="${up}" data-kind="${kind}"${stem && ` data-stem="${stem}"`}`, about, up, more })}
<script type="module" src="${up}page.js"></script>
</head>
<body>
<noscript><p class="note">JavaScript is off. You can read the lessons and their figures; the exercises need it.</p></noscript>
<a class="skip" href="#main">To the text</a>${kind === "chapter" ? '\n<a class="skip" href="#exercise">To the exercise</a>' : ""}
<header class="top">
<a class="home" href="${up}index.html"${kind === "start" ? ' aria-current="page"' : ""}>Ray casting<span>, step by step</span></a>
<nav aria-label="Chapters"><button type="button" id="titles" popovertarget="menu" aria-label="Titles and progress">☰</button><ol>${chapters(false)}</ol><p class="title">${stem && escape(shortTitle(stem))}</p>
<ol id="menu" popover>${chapters(true)}</ol></nav>
<div class="tools"><a href="${up}figures.html"${kind === "figures" ? ' aria-current="page"' : ""}>Figures</a>${isHandout ? "" : `<a href="${up}mistakes.html${stem && `#${stem}`}"${kind === "mistakes" ? ' aria-current="page"' : ""}>Mistakes</a>`}<button type="button" id="theme">Theme</button></div>
</header>
${main}
</body>
</html>
`;
}

function write(name, text) {
    const file = join(site, name);
    mkdirSync(dirname(file), { recursive: true });
    writeFileSync(file, address ? text.replace("<title>", `<link rel="canonical" href="${address}${name.replace("index.html", "")}">\n$&`) : text);
}

write("course.webmanifest", JSON.stringify({ name: "Ray casting, step by step", short_name: "Ray casting", description: ABOUT, start_url: "index.html", scope: ".",
    display: "minimal-ui", background_color: "#ffffff", theme_color: "#005e97", icons: [{ src: "icon.svg", type: "image/svg+xml", sizes: "any" }] }));

const inline = (text) => text.replace(/`([^`]*)`/g, "<code>$1</code>");

/** A lesson begins with what it gives and the picture that it leads to; the lecture's questions are below that, folded. */
function withOpening({ html, gives, time }, stem) {
    const at = html.indexOf("<h2"), take = (pattern) => pattern.exec(html.slice(0, at))?.[0] ?? "";
    const title = take(/<h1.*?<\/h1>/s), asked = take(/<blockquote>.*<\/blockquote>/s), about = take(/<div class="table".*?<\/table><\/div>/s);
    const goal = /id="the-picture-that-your-code-draws".*?(<img [^>]*>)/s.exec(html)[1].replace(/ loading="lazy"| class="picture"/g, "")
        .replace(/width="(\d+)" height="(\d+)"/, (_, width, height) => `width="${Math.round(Math.min(208, 168 * width / height))}" height="${Math.round(Math.min(168, 208 * height / width))}"`);
    const rest = [title, asked, about].reduce((text, each) => text.replace(each, ""), html);
    return `<header class="opening"><div>${title}
<p>You write ${inline(escape(gives.split(";")[0]))}. <small>${escape(time.split(";")[0])}.${isHandout ? "" : ` <a href="lecture.html#${slideWith(new RegExp(`data-figure=.*"${stem}.html#exercise"`, "s"))}">Its slides</a>.`}</small></p>
<details><summary>The lecture's questions</summary>${asked}${about}</details></div>
<a href="#the-picture-that-your-code-draws">${goal}</a></header>\n${rest}`;
}

// ---- the slides ---------------------------------------------------------------------------------

const slides = isHandout ? "" : withCodes(typeset(readFileSync(lectureFile, "utf8")), address);
const onSlides = [...new Set([...slides.matchAll(/ data-figure="([^"]*)"/g)].map(([, name]) => name))];
/** The first slide that has this. */
const slideWith = (pattern) => slides.split("<section ").find((each) => pattern.test(each)).match(/ data-name="([^"]*)"/)[1];

// ---- a chapter ----------------------------------------------------------------------------------

/** The exercise as it is at the beginning: a handout's student has changed the other file. */
const fileOf = (stem) => [`build/blanks/${stem}.c`, `exercises/${stem}.c`].find((path) => existsSync(join(root, path)));
/** Without the words for a terminal. */
const textOf = (path) => readFileSync(join(root, path), "utf8").replace(/^\/\/ (Questions and rules|After each change):.*\n/gm, "").replace(/ \(make [^)]*\)/g, "");

// What the browser refuses to keep is downloaded from the page that has it (page/page.js).
const unsaved = '<p class="note" id="unsaved" role="alert" hidden><span></span> <button type="button">Download submission.zip</button></p>';

function exercise(stem) {
    return `<section class="exercise" id="exercise" aria-labelledby="exercise-title" tabindex="-1">
<div class="exercise-head">
<h2 id="exercise-title">Exercise ${stem.slice(0, 2)}</h2>
<div class="files" role="tablist" aria-label="Files of the exercise">
<button type="button" role="tab" id="tab-answer" aria-controls="panel-answer" aria-selected="true">${stem}.c</button>
<button type="button" role="tab" id="tab-contract" aria-controls="panel-contract" aria-selected="false" tabindex="-1">${stem}.h</button>
</div>
</div>
<div class="panel" role="tabpanel" id="panel-answer" aria-labelledby="tab-answer"><div id="editor"><pre tabindex="0"><code>${
    coloredC(textOf(fileOf(stem)))}</code></pre></div></div>
<div class="panel" role="tabpanel" id="panel-contract" aria-labelledby="tab-contract" hidden><pre tabindex="0"><code>${
    coloredC(textOf(`exercises/${stem}.h`))}</code></pre></div>
<div class="actions">
<button type="button" class="main" id="judge">Judge <kbd id="judge-keys">Ctrl Enter</kbd></button>
<button type="button" id="hint">Hint</button>
<button type="button" id="reset">Reset</button>
<button type="button" id="undo-reset" hidden>Undo the reset</button>
<p class="state" id="state" role="status"></p>
</div>
<p class="keys">Tab indents. To leave the editor by keyboard, press <kbd>Esc</kbd>, then <kbd>Tab</kbd>.</p>
<div class="progress" id="progress" hidden><label for="bar" id="progress-words"></label><progress id="bar" max="1"></progress></div>
<p class="note" id="trouble" role="alert" hidden></p>
${unsaved}
<section class="verdict" id="verdict" aria-labelledby="verdict-title">
<h3 class="aloud" id="verdict-title">Verdict</h3>
<ol id="strip" aria-label="The functions"></ol>
<p id="first" aria-live="polite">Nothing is judged yet. Press <q>Judge</q>, or stop typing for a moment.</p>
<div class="found"><div id="details"></div><div id="verdict-pictures"></div></div>
<p id="way-on"></p>
<ol id="hints" aria-live="polite" aria-label="Hints"></ol>
</section>
</section>`;
}

for (const stem of stems) {
    const lesson = lessons[stem];
    write(`${stem}.html`, frame({ title: `${lesson.title} · Ray casting`, kind: "chapter", stem, mathematics: lesson.html.includes('class="katex'),
        main: `<main class="chapter" id="main">
<article class="lesson" id="lesson" aria-label="Lesson">
${withOpening(lesson, stem)}
</article>
<div class="divider" id="divider" role="separator" tabindex="0" aria-orientation="vertical" aria-label="Room for the lesson, in percent" aria-controls="lesson" aria-valuemin="25" aria-valuemax="75" aria-valuenow="50"></div>
${exercise(stem)}
</main>
<div class="views" id="views" role="tablist" aria-label="Parts of the chapter">${["lesson", "code", "verdict"].map((view) =>
        `<button type="button" role="tab" id="view-${view}" aria-controls="${view === "code" ? "exercise" : view}" aria-selected="false">${view[0].toUpperCase()}${view.slice(1)}</button>`).join("")}</div>` }));
}
writeFileSync(`${site}-course.json`, JSON.stringify({ stems, functions, titles: Object.fromEntries(stems.map((stem) => [stem, lessons[stem].title])) }));

// ---- the start page -----------------------------------------------------------------------------

const finale = "chapters/07-shading/finale.png";
used.add(finale);
const cards = stems.map((stem) => `<li data-stem="${stem}"><a href="${stem}.html"><span class="number">${stem.slice(0, 2)}</span>
<span class="title">${escape(shortTitle(stem))}</span></a>
<p>You write ${inline(escape(lessons[stem].gives))}.</p>
<p class="meta"><span class="time">${escape(lessons[stem].time.split(";")[0])}</span><span class="done">${countOf(stem)}</span></p></li>`).join("\n");
write("index.html", frame({ title: "Ray casting, step by step", kind: "start", main: `<main class="start" id="main">
<div class="hero">
<figure id="picture"><img src="${finale}" alt="A sphereflake of mirrors among marbles, cast by the code of this course" width="1280" height="720" fetchpriority="high"><figcaption></figcaption></figure>
<div class="lead">
<h1>Ray casting, step by step</h1>
<p>Answer the questions of a lecture, in C, one function at a time. Each chapter is a short lesson with figures that you can move, and an
exercise. The judge says whether your function is right. If it is wrong, the judge says how, and often why. At the end, your own functions draw this picture.</p>
<p>Everything runs in this page: the compiler, the judge and your code. There is nothing to install, and nothing is sent anywhere.</p>
<p><a class="begin" id="begin" href="${stems[0]}.html">Begin with chapter 01</a></p>
</div>
</div>
<section aria-labelledby="chapters">
<h2 id="chapters">The chapters</h2>
<p id="so-far" role="status"></p>
<ol class="cards">
${cards}
</ol>
</section>
<section class="yours" aria-labelledby="yours">
<h2 id="yours">Your answers</h2>
<p>Your answers are saved in this browser, on this machine, and nowhere else. To hand them in, or to go on with another browser, download them as one archive.</p>
<div class="actions">
<button type="button" class="main" id="download">Download all answers</button>
<label class="button" for="upload">Upload answers<input type="file" id="upload" accept=".zip,.c" multiple></label>
${handIn ? `<a class="button" href="${escape(handIn)}" rel="noopener">Hand in</a>` : ""}
<p class="state" id="state" role="status"></p>
</div>
<p class="note" id="trouble" role="alert" hidden></p>
${unsaved}
<p>The archive is <code>submission.zip</code>, the same that <code>make submission</code> makes in the toolkit.${handIn ? "" : " Hand it in the way that your instructor says."}
The verdicts here are for you: marks come from your instructor, who judges the archive again.</p>
</section>
<section aria-labelledby="keys">
<h2 id="keys">Keys</h2>
<dl class="keys-table">
<div><dt><kbd>Ctrl</kbd> <kbd>Enter</kbd>, on a Mac <kbd>⌘</kbd> <kbd>Enter</kbd></dt><dd>judges your answer; a pause in typing does as well</dd></div>
<div><dt><kbd>Esc</kbd>, then <kbd>Tab</kbd></dt><dd>leaves the editor</dd></div>
<div><dt><kbd>←</kbd> <kbd>→</kbd></dt><dd>in a figure that fills the screen: one step back or forward</dd></div>
<div><dt><kbd>Esc</kbd></dt><dd>closes a figure that fills the screen</dd></div>
</dl>
</section>
<footer><p>The questions, and the order of the steps, are from the lecture deck <cite>Ray Tracing, Part I</cite> by Geoffrey Matthews, Department of Computer
Science, Western Washington University, Fall 2015. The sphereflake is from Eric Haines' Standard Procedural Databases.</p></footer>
</main>` }));

// ---- the gallery of known mistakes: page/mistakes.js fills it ------------------------------------

if (!isHandout)
    write("mistakes.html", frame({ title: "What went wrong · Ray casting", kind: "mistakes", main: `<main class="figures mistakes" id="main">
<h1>What went wrong</h1>
<p>Each picture here is cast in this page by one known mistake. Which line was it? You can turn the picture. The pictures of a chapter open when all its functions are right.</p>
<ol class="chapters">${stems.map((stem) => `<li data-stem="${stem}"><a href="#${stem}"><span class="number">${stem.slice(0, 2)}</span> ${escape(shortTitle(stem))}</a> <span class="done">${countOf(stem)}</span></li>`).join("\n")}</ol>
<p class="note" id="trouble" role="alert" hidden></p>
<p id="closed" role="status"></p>
<section id="question" aria-labelledby="asked" hidden>
<figure><div class="stage"><canvas width="480" height="360" tabindex="0" role="img" aria-label="The scene. Arrow keys turn it, plus and minus go closer and farther away."></canvas></div>
<figcaption class="actions"><span id="by" role="status"></span> <button type="button" id="compare" aria-pressed="false">Show the right picture</button></figcaption></figure>
<div><h2 id="asked"></h2>
<ol id="choices"></ol>
<div class="actions"><button type="button" id="back">Back</button><button type="button" class="main" id="next">Next</button><span class="state" id="of"></span></div></div>
</section>
</main>` }));

// ---- the lecture, and all figures, for a lecturer -----------------------------------------------

if (!isHandout) {
    mkdirSync(join(site, "lecture"), { recursive: true });
    for (const [, name] of slides.matchAll(/src="lecture\/([^"]*)\.svg"/g)) {
        for (const theme of ["", "-dark"])
            copyFileSync(join(drawnFolder, name.replace(/(-4x3)?-step\d+$/, ""), `${name}${theme}.svg`), join(site, `lecture/${name}${theme}.svg`));
    }
    for (const [, path] of slides.matchAll(/src="([^"]*\.png)"/g))
        used.add(path);
    const films = existsSync(filmsFolder) ? readdirSync(filmsFolder).filter((name) => existsSync(join(filmsFolder, name, `${name}.mp4`))) : [];
    mkdirSync(join(site, "films"), { recursive: true });
    for (const file of films.flatMap((name) => [`${name}/${name}.mp4`, `${name}/${name}-dark.mp4`]).filter((name) => existsSync(join(filmsFolder, name))))
        copyFileSync(join(filmsFolder, file), join(site, "films", file.split("/")[1]));
    const more = '<link rel="stylesheet" href="mathematics.css">\n<link rel="stylesheet" href="lecture.css">\n';
    write("lecture.html", lecturePage({ slides, films, head: head({ title: "Lecture · Ray casting", attributes: ' data-kind="lecture"', policy: `${POLICY}; media-src 'self'`, more }) }));
}

// In the order of the lecture, and those that it does not show at the end of their chapter's (08's at the very end). A handout has no lecture.
const figures = stems.flatMap((stem) => readdirSync(join(root, "chapters", stem)).filter((name) => name.endsWith(".svg") && !/-step\d/.test(name)).map((file) => {
    const name = file.slice(0, -4), svg = readFileSync(join(root, "chapters", stem, file), "utf8");
    return { stem, name, file: `chapters/${stem}/${file}`, title: /<title[^>]*>(.*?)<\/title>/s.exec(svg)[1], words: /<desc[^>]*>(.*?)<\/desc>/s.exec(svg)[1].replace(/"/g, "&quot;") };
}));
const placeOf = ({ stem, name }) => onSlides.indexOf(name) + 1 || (stem === stems.at(-1) ? 1000 : 0) +
    Math.max(0, ...figures.filter((each) => each.stem === stem).map((each) => onSlides.indexOf(each.name) + 1)) + 0.5;
figures.sort((a, b) => placeOf(a) - placeOf(b));
write("figures.html", frame({ title: "Figures · Ray casting", kind: "figures", main: `<main class="figures" id="main">
<h1>Figures</h1>
<p>These are all figures of the course, in the order of the lecture, for the projector. <q>Full screen</q> shows one alone: the arrow keys go through its steps, then to the next
figure. <kbd>Esc</kbd> returns to this page.${isHandout ? "" : " <a href=\"lecture.html\">The lecture</a> has them on its slides."}</p>
<div class="grid">
${figures.map(({ stem, name, file, title, words }) => `<section id="${name}" aria-label="${title}"><h2><a href="#${name}">${title}</a></h2>
<p class="meta"><a href="${stem}.html">Chapter ${stem.slice(0, 2)}</a> · <a href="${stem}.html#exercise">its exercise</a>${onSlides.includes(name) ? ` · <a href="lecture.html#${slideWith(new RegExp(` data-figure="${name}"`))}">its slide</a>` : ""}</p>
${figure({ root, file, words, first: false, used }).replace(" data-src=", ` data-step="1" data-src=`)}</section>`).join("\n")}
</div>
</main>` }));

// ---- the optional tasks, and the files that lessons link to -------------------------------------

function textPage({ title, html }, note = "") {
    return frame({ title: `${title} · Ray casting`, kind: "text", mathematics: html.includes('class="katex'),
        main: `<main class="text" id="main">${note}<article class="lesson">${html}</article></main>` });
}
if (existsSync(join(root, "exercises/optional/README.md"))) {
    const optional = lessonHtml({
        root, path: "exercises/optional/README.md", pageOf, used });
    write("optional.html", textPage(optional, '<p class="note">These tasks need the toolkit and a terminal: this page cannot judge them.</p>\n'));
}
if (existsSync(join(root, ENGINES)))
    write("engines.html", textPage(lessonHtml({
        root, path: ENGINES, pageOf, used })));
for (const stem of stems)
    pageOf(`exercises/${stem}.h`);
// A listing links to the headers that it includes.
for (const path of listings) {
    const code = coloredC(readFileSync(join(root, path), "utf8")).replace(/(#include[^"\n]*)&quot;|"((?:common|exercises)\/[^"<]+\.h)"/g, (whole, _, header) => {
        const page = header && pageOf(header);
        return page ? `"<a href="../../${page}">${header}</a>"` : whole;
    });
    write(`listings/${path}.html`, frame({ title: `${path} · Ray casting`, kind: "listing", up: "../../",
        main: `<main class="listing" id="main"><h1><code>${escape(path)}</code></h1><pre tabindex="0"><code>${code}</code></pre></main>` }));
}

// ---- pictures, fonts, styles --------------------------------------------------------------------

for (const path of used) {
    mkdirSync(dirname(join(site, path)), { recursive: true });
    const [, name, drawn] = /^chapters\/[^/]+\/figures\/(([^/]+?)(?:-4x3)?(?:-step\d+)?(?:-dark)?\.svg)$/.exec(path) ?? [];
    copyFileSync(drawn ? join(drawnFolder, drawn, name) : join(root, path), join(site, path));
}
const katex = packageFolder("katex");
// Every browser of today reads woff2, so the other formats are left out; so are fonts that no formula uses.
const allHtml = Object.values(lessons).map((lesson) => lesson.html).join("");
const needed = (css) => css.replace(/,url\([^)]*\.(woff|ttf)\) format\("[a-z]+"\)/g, "")
    .replace(/@font-face\{[^}]*font-family:"?KaTeX_(AMS|Caligraphic|Fraktur|SansSerif|Script|Typewriter)"?[^}]*\}/g, "")
    .replace(/font-display:block/g, "font-display:swap");
const css = needed(readFileSync(join(katex, "dist/katex.min.css"), "utf8"));
write("mathematics.css", css);
mkdirSync(join(site, "fonts"), { recursive: true });
for (const [, font] of css.matchAll(/url\(fonts\/([^)]*\.woff2)\)/g))
    copyFileSync(join(katex, "dist/fonts", font), join(site, "fonts", font));
if (!allHtml.includes('class="katex'))
    throw new Error("no lesson has a formula: is the mathematics still typeset?");
const serif = packageFolder("@fontsource/source-serif-4");
for (const kind of ["400-normal", "400-italic", "600-normal"])
    copyFileSync(join(serif, `files/source-serif-4-latin-${kind}.woff2`), join(site, "fonts", `source-serif-${kind}.woff2`));
for (const name of ["style.css", "lecture.css", "early.js", "icon.svg"])
    copyFileSync(new URL(`../page/${name}`, import.meta.url), join(site, name));
