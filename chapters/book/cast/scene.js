// scene.js - how the viewpoint of a scene moves, and what is in the scene: a text in NFF (common/scene.h).

/** @typedef {[number, number, number]} Vector */

const plus = (a, b) => a.map((x, i) => x + b[i]);
const minus = (a, b) => a.map((x, i) => x - b[i]);
const times = (s, a) => a.map((x) => s * x);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => times(1 / Math.sqrt(dot(a, a)), a);

/** @typedef {{from: Vector, at: Vector, up: Vector, angle: number}} View */

/** @returns {View} of the ten numbers of cast.c */
export const viewOf = (numbers) => ({ from: numbers.slice(0, 3), at: numbers.slice(3, 6), up: numbers.slice(6, 9), angle: numbers[9] });
export const numbersOf = ({ from, at, up, angle }) => [...from, ...at, ...up, angle];

/** The camera's axes, as chapter 02's solution for right-handed worlds has them. */
function axes({ from, at, up }) {
    const forward = unit(minus(at, from)), right = unit(cross(forward, up));
    return { forward, right, up: cross(right, forward) };
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

/** From beside: the eye, and what it looks at. */
export function beside(view) {
    const { forward, right, up } = axes(view), way = minus(view.at, view.from), length = Math.sqrt(dot(way, way)), at = plus(view.from, times(0.55, way));
    return { ...view, at, from: plus(at, times(1.8 * length, unit(plus(right, plus(times(0.45, up), times(-0.25, forward)))))), angle: 42 };
}

// ---- where things are on the picture, and moved there -----------------------------------------------

/** A point in the picture: right and down, in parts of the picture's width, from its middle; ahead: its distance along forward. */
export function seen(view, point) {
    const { forward, right, up } = axes(view), to = minus(point, view.from), ahead = dot(to, forward);
    const width = 2 * ahead * Math.tan(view.angle * Math.PI / 360);
    return { across: dot(to, right) / width, down: -dot(to, up) / width, ahead };
}

/** A point, moved by parts of the picture's width to the right and down, and nearer by a part of its distance. */
export function moved(view, point, across, down, nearer = 0) {
    const { forward, right, up } = axes(view), { ahead } = seen(view, point), width = 2 * ahead * Math.tan(view.angle * Math.PI / 360);
    return plus(point, plus(plus(times(across * width, right), times(-down * width, up)), times(-nearer * ahead, forward)));
}

/** The spheres and lights of a scene: {kind: "s" | "l", line, at}, lines from 0. */
export const thingsOf = (text) => text.split("\n").flatMap((words, line) => {
    const [kind, ...numbers] = words.replace(/#.*/, "").trim().split(/\s+/), at = numbers.slice(0, 3).map(Number);
    return (kind === "s" || kind === "l") && at.length === 3 && at.every(Number.isFinite) ? [{ kind, line, at }] : [];
});

const short = (x) => String(Number(x.toPrecision(5)));
/** The text with the thing of a line somewhere else. */
export const withThing = (text, line, at) => text.split("\n").map((words, i) =>
    i === line ? words.replace(/^(\s*[sl])\s+\S+\s+\S+\s+[^\s#]+/, `$1 ${at.map(short).join(" ")}`) : words).join("\n");
