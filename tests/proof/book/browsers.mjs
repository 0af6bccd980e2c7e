// browsers.mjs - the browsers that the tests of the page start. As a program it says which of those named are missing,
// and how to get them, before anything is built: node browsers.mjs chromium firefox
import { existsSync, statSync } from "node:fs";
import { delimiter, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const BROWSERS = {
    chromium: { title: "Chromium", path: process.env.CHROMIUM, names: ["chromium", "chromium-browser", "google-chrome"] },
    firefox: { title: "Firefox", path: process.env.FIREFOX, names: ["firefox-esr", "firefox"] },
};
const isFile = (path) => existsSync(path) && statSync(path).isFile();

/** The program of a browser: CHROMIUM or FIREFOX of the environment, or the first in PATH. undefined if there is none. */
export function programOf(browser) {
    const { path, names } = BROWSERS[browser];
    const places = path ? [path] : (process.env.PATH ?? "").split(delimiter).flatMap((folder) => names.map((name) => join(folder, name)));
    return places.find(isFile);
}

/** A line for each of the browsers that is missing. */
export function missing(browsers) {
    return browsers.map((browser) => {
        if (!(browser in BROWSERS))
            return `check-book: BROWSERS=${browser}: expected chromium or firefox`;
        const { title, path, names } = BROWSERS[browser], others = browsers.filter((each) => each !== browser && each in BROWSERS && programOf(each));
        return programOf(browser) ? "" : `check-book: ${title} is missing (${path ? `no ${path}` : `no ${names.join(", ")} in PATH`}): ` +
            `'make setup FOR=contributor' installs it${others.length > 0 ? `, and 'make check-book BROWSERS=${others.join(" ")}' tests without it` : ""}`;
    }).filter((line) => line !== "");
}

if (resolve(process.argv[1] ?? "") === fileURLToPath(import.meta.url)) {
    const lines = missing(process.argv.slice(2));
    lines.forEach((line) => console.error(line));
    process.exitCode = lines.length > 0 ? 1 : 0;
}
