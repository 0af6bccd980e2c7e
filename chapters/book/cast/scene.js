// scene.js - a scene as its text: where its camera, spheres and lights are, and the same text with one of them elsewhere.
// What is wrong with a text says common/scene.c; here a line that cannot be read counts as absent.

/** @typedef {[number, number, number]} Vector */

export const plus = (a, b) => a.map((x, i) => x + b[i]);
export const minus = (a, b) => a.map((x, i) => x - b[i]);
export const times = (s, a) => a.map((x) => s * x);
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const unit = (a) => times(1 / Math.sqrt(dot(a, a)), a);

/**
 * @returns {{lines: string[], view: {from: Vector, at: Vector, up: Vector, angle: number},
 *            places: {line: number, kind: "sphere" | "light", at: Vector, radius: number, name: string}[]}}
 */
export function readScene(text) {
    const lines = text.split("\n"), view = { from: [0, 0, 5], at: [0, 0, 0], up: [0, 1, 0], angle: 45 }, places = [];
    const counts = { sphere: 0, light: 0 };
    lines.forEach((line, number) => {
        const [word, ...numbers] = line.replace(/#.*/, "").trim().split(/\s+/), values = numbers.map(Number);
        if (values.some(Number.isNaN))
            return;
        if (word === "angle")
            view.angle = values[0];
        else if (["from", "at", "up"].includes(word))
            view[word] = values.slice(0, 3);
        else if (word === "s" || word === "l") {
            const kind = word === "s" ? "sphere" : "light", count = counts[kind]++;
            places.push({ line: number, kind, at: values.slice(0, 3), radius: values[3] ?? 0,
                name: kind === "light" ? `light ${count + 1}` : `sphere ${count < 26 ? String.fromCharCode(65 + count) : count + 1}` });
        }
    });
    return { lines, view, places };
}

const short = (x) => String(Number(x.toPrecision(5)));
const numbers = (vector) => vector.map(short).join(" ");

/** The text with the sphere or the light of a line at another place. */
export function withPlace({ lines }, line, at) {
    const [, word, rest] = /^\s*(\S+)\s+(?:\S+\s+){2}\S+(.*)$/.exec(lines[line]);
    return lines.with(line, `${word} ${numbers(at)}${rest}`).join("\n");
}

/** The text with another viewpoint. */
export function withView({ lines }, view) {
    return lines.map((line) => {
        const word = /^\s*(from|at|up|angle)\b/.exec(line)?.[1];
        return word === undefined ? line : word === "angle" ? `angle ${short(view.angle)}` : `${word} ${numbers(view[word])}`;
    }).join("\n");
}

/** The camera's axes, as chapter 02's solution for right-handed worlds has them. */
function axes({ from, at, up }) {
    const forward = unit(minus(at, from)), right = unit(cross(forward, up));
    return { forward, right, up: cross(right, forward) };
}

/** Where a point is on a screen, in pixels; null behind the eye. scale: pixels of a unit there. */
export function project(view, point, { width, height }) {
    const { forward, right, up } = axes(view), seen = minus(point, view.from), ahead = dot(seen, forward);
    if (!(ahead > 0))
        return null;
    const scale = width / 2 / Math.tan(view.angle * Math.PI / 360) / ahead;
    return { x: width / 2 + scale * dot(seen, right), y: height / 2 - scale * dot(seen, up), scale };
}

/** A point moved by pixels, in the plane through it that faces the eye. */
export function moved(view, point, dx, dy, screen) {
    const { right, up } = axes(view), { scale } = project(view, point, screen) ?? { scale: 100 };
    return plus(point, plus(times(dx / scale, right), times(-dy / scale, up)));
}

/** The eye on a sphere around what it looks at: degrees to the right, and up. */
export function orbit(view, across, above) {
    const axis = unit(view.up), arm = minus(view.from, view.at), distance = Math.sqrt(dot(arm, arm));
    const level = unit(minus(arm, times(dot(arm, axis), axis))), side = cross(axis, level);
    const high = Math.asin(Math.max(-1, Math.min(1, dot(arm, axis) / distance)));
    const most = Math.PI / 2 - 0.01, next = Math.max(-most, Math.min(most, high + above * Math.PI / 180)), turn = across * Math.PI / 180;
    const out = plus(times(Math.cos(turn), level), times(Math.sin(turn), side));
    return { ...view, from: plus(view.at, times(distance, plus(times(Math.cos(next), out), times(Math.sin(next), axis)))) };
}

/** The eye nearer to what it looks at, or farther away. */
export const zoom = (view, factor) => ({ ...view, from: plus(view.at, times(factor, minus(view.from, view.at))) });

/** The eye and what it looks at, moved together: parts of their distance to the right, up, ahead. */
export function fly(view, across, above, ahead) {
    const { forward, right, up } = axes(view), way = minus(view.at, view.from), step = Math.sqrt(dot(way, way));
    const by = times(step, plus(plus(times(across, right), times(above, up)), times(ahead, forward)));
    return { ...view, from: plus(view.from, by), at: plus(view.at, by) };
}
