// lecture.mjs - the page of the lecture: the slides that chapters/slides/lecture_page.py writes, with their mathematics
// typeset, and what a lecturer does with them (page/lecture.js). Runs when the site is built.
import katex from "katex";
import { renderSVG } from "uqr";
import { escape } from "./lesson.mjs";

const unescape = (text) => text.replace(/&lt;/g, "<").replace(/&gt;/g, ">").replace(/&#x27;/g, "'").replace(/&quot;/g, '"').replace(/&amp;/g, "&");

/** The slides as HTML with typeset formulas. */
export function typeset(slides) {
    return slides.replace(/<math-tex( class="display")?>(.*?)<\/math-tex>/gs, (_, display, tex) =>
        katex.renderToString(unescape(tex), { displayMode: Boolean(display), throwOnError: true, strict: "error", output: "htmlAndMathml" }));
}

/** The codes on slides, for phones; none if the address of the site is not known. */
export function withCodes(slides, address) {
    return slides.replace(/(<a class="qr" href="(.*?)")><\/a>/g, (_, link, page) =>
        (address ? `${link} aria-label="This on a phone" tabindex="-1">${renderSVG(address + page, { border: 2 })}</a>` : ""));
}

/** Keys, in the order of the help. */
const KEYS = [["→ Space PageDown", "next"], ["← PageUp", "back"], ["Home, End", "the first, the last"], ["F", "full screen"], ["S", "window for the speaker: notes, next slide, time"],
    ["O", "overview"], ["G", "go to a number or a name"], ["B .", "black screen"], ["D", "draw; again: stop"], ["C", "clear the drawing"], ["N", "numbers of the figure"], ["Q", "the slide's code for phones: large, small"],
    ["V", "the film of the slide"], ["P", "paste a student's line: it is judged, and drawn"], ["T", "light or dark"], ["?", "these keys"]];

/**
 * @param {{slides: string, films: string[], head: string}} given films: names of those that the site has
 */
export function lecturePage({ slides, films, head }) {
    const withFilms = slides.replace(/ data-film="([^"]*)"/g, (whole, name) => (films.includes(name) ? whole : ""));
    return `${head}
<script src="lecture.js" defer></script>
</head>
<body>
<noscript><p class="note">JavaScript is off, and the slides need it. <a href="figures.html">All figures</a> are on one page.</p></noscript>
<main id="stage">
${withFilms}</main>
<canvas id="pen" hidden></canvas>
<div id="black" hidden></div>
<nav class="tools" aria-label="Slides">
<button type="button" data-do="back" aria-label="Back">‹</button><button type="button" data-do="next" aria-label="Next">›</button><button type="button" data-do="film" hidden>Film</button>
<button type="button" data-do="numbers" hidden>Numbers</button><button type="button" data-do="overview">Overview</button><button type="button" data-do="speaker">Speaker</button>
<button type="button" data-do="full">Full screen</button><button type="button" id="theme" data-do="theme">Theme</button><button type="button" data-do="help" aria-label="Keys">?</button><a href="index.html">Course</a>
</nav>
<aside id="speaker" hidden aria-label="For the speaker"><p class="time"><span id="clock"></span> <span id="planned"></span></p><div id="notes"></div><p id="following"></p></aside>
<dialog id="jump"><form method="dialog"><label>Number or name <input list="names" autocomplete="off"></label><datalist id="names"></datalist></form></dialog>
<dialog id="film"><video controls muted playsinline></video></dialog>
<dialog id="line"><form method="dialog"><p><select aria-label="Function"></select> <button type="button" id="judge-line">Judge</button> <button>Close</button></p>
<textarea rows="2" aria-label="A line, or a whole function" placeholder="what it returns, lines with a return, or the whole function" spellcheck="false"></textarea><output></output></form></dialog>
<dialog id="help"><h2>Keys</h2><dl>${KEYS.map(([key, words]) => `<div><dt>${key.split(" ").map((each) => `<kbd>${escape(each)}</kbd>`).join(" ")}</dt><dd>${escape(words)}</dd></div>`).join("")}</dl></dialog>
<p class="aloud" role="status" id="spoken"></p>
</body>
</html>
`;
}
