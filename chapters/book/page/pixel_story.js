// pixel_story.js - the story of a pixel, as cast/cast.c tells it: its lines, and its rays drawn in the scene.
import { moved, seen } from "../cast/scene.js";
import { element } from "./verdict.js";

const LETTERS = { ray: "v", normal: "n", light: "l", shadow: "l", mirror: "m" };
const SCREEN = 0.3; // how far away the screen is drawn, in parts of its distance: often it is in the middle of the scene
const NORMAL = 0.12; // how long a normal is drawn, in parts of the width of what is seen there

const along = (a, b, part) => a.map((x, i) => x + part * (b[i] - x));

/** A heading, or a label, a value, and whose function that is; or a line as it is (common/story.h). */
function lineOf(line, chapterOf) {
    const [label, value, names = ""] = line.split("\t");
    if (value === undefined)
        return element(line.startsWith(" ") ? "p" : "h4", line.startsWith(" ") ? { class: "whole" } : {}, line.trim());
    const by = names.split(" ").filter(Boolean).map((each) => element("a", { href: `${chapterOf[each]}.html` }, `${chapterOf[each]?.slice(0, 2)} ${each}`));
    return element("p", {}, element("span", {}, label), element("code", {}, value), ...by);
}

/** @returns {{lines: Element[], segments: {name: string, from: number[], to: number[]}[]}} the segments in the world, with all digits */
export function storyOf(said, chapterOf) {
    const lines = said.slice(said.indexOf("\nFrom the pixel")).split("\n").filter((line) => line !== "" && !/^\d\d-/.test(line));
    const segments = lines.filter((line) => line.startsWith("\t")).map((line) => line.slice(1).split(" "))
        .map(([name, ...numbers]) => ({ name, from: numbers.slice(0, 3).map(Number), to: numbers.slice(3).map(Number) }));
    return { lines: lines.filter((line) => !line.startsWith("\t")).map((line) => lineOf(line, chapterOf)),
        segments: segments.filter(({ name, from, to }) => name in LETTERS && [...from, ...to].every(Number.isFinite)) };
}

/**
 * Draws the segments over the picture of the scene.
 * @param {SVGElement} svg its unit is the picture's width, its origin the middle
 * @param {import("../cast/scene.js").View} view from where the picture is seen
 * @param {import("../cast/scene.js").View} home whose pixel that is: from there a ray is a point, and the screen is the picture
 */
export function drawStory(svg, segments, view, home, { width, height }, pixel) {
    let drawn = "";
    const isAside = view !== home, place = (point) => { const { across, down } = seen(view, point); return [across, down].map((x) => x.toFixed(5)); };
    const isAhead = (point) => seen(view, point).ahead > 0;
    const text = (point, words, dy = -0.012) => { const [x, y] = place(point); drawn += isAhead(point) ? `<text x="${x}" y="${y}" dx="0.015" dy="${dy}">${words}</text>` : ""; };
    const dot = (point, name) => { const [x, y] = place(point); drawn += isAhead(point) ? `<circle class="${name}" cx="${x}" cy="${y}" r="0.011"/>` : ""; };
    function line(from, to, name) {
        const a = seen(view, from).ahead, b = seen(view, to).ahead, least = 1e-3 * Math.max(a, b);
        if (least <= 0)
            return;
        // Behind the eye is no picture.
        const [start, end] = [a < least ? along(from, to, (least - a) / (b - a)) : from, b < least ? along(to, from, (least - b) / (a - b)) : to].map(place);
        drawn += `<line class="${name}" x1="${start[0]}" y1="${start[1]}" x2="${end[0]}" y2="${end[1]}"/>`;
    }
    if (isAside) {
        const onScreen = (x, y) => along(home.from, moved(home, home.at, x / width - 0.5, (y - height / 2) / width), SCREEN);
        const frame = [[0, 0], [width, 0], [width, height], [0, height]].map(([x, y]) => onScreen(x, y));
        frame.forEach((corner, i) => { line(corner, frame[(i + 1) % 4], "screen"); line(home.from, corner, "edge"); });
        dot(onScreen(pixel.column + 0.5, pixel.row + 0.5), "screen");
        dot(home.from, "ray");
        text(home.from, "<tspan>p</tspan>, the eye", 0.06);
        text(frame[1], "screen");
    }
    for (const { name, from, to } of segments) {
        const { ahead } = seen(home, from), end = name === "normal" ? along(from, to, NORMAL * 2 * ahead * Math.tan(home.angle * Math.PI / 360)) : to;
        line(from, end, name);
        if (name === "ray") {
            dot(to, "ray");
            text(to, "<tspan>p + t v</tspan>");
        }
        if (name !== "ray" || isAside) // a light may be far away
            text(along(from, end, { normal: 1, ray: 0.65 }[name] ?? Math.min(0.5, (name === "mirror" ? 0.15 : 0.3) * ahead / Math.hypot(...end.map((x, i) => x - from[i])))),
                `<tspan>${LETTERS[name]}</tspan>`);
    }
    svg.innerHTML = drawn;
}
