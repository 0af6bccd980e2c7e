// pool.js - a pool of Workers that cast a picture tile by tile. Nothing is shared: each has its own instance of the program.

const LONGEST = 30_000; // milliseconds for a tile; a wrong answer may need any time, a busy machine more than an idle one
const SOON = 500;       // milliseconds after which a Worker is ended whose picture nobody wants any more
const TILE = { width: 64, height: 48 };

/** The picture was stopped: there is another one, or a new scene. */
export class Replaced extends Error {}

/** The tiles of a pass, in reading order. Who casts by a name casts a whole picture. */
function tilesOf(pass) {
    const { width, height } = pass, tiles = [], size = pass.caster ? pass : TILE;
    for (let top = 0; top < height; top += size.height)
        for (let left = 0; left < width; left += size.width)
            tiles.push({ ...pass, left, top, right: Math.min(width, left + size.width), bottom: Math.min(height, top + size.height) });
    return tiles;
}

/**
 * @typedef {{width: number, height: number, samples: number, depth: number, view: number[] | null, caster: string, isRace?: boolean, mistake: number}} Pass
 * @typedef {{program: WebAssembly.Module, scene: string}} Opened what is cast: a scene, by a program
 */
export class Pool {
    /**
     * @param {() => Worker} start
     * @param {number} size
     */
    constructor(start, size = Math.min(16, navigator.hardwareConcurrency || 2)) {
        this.start = start;
        this.workers = Array.from({ length: size }, () => ({ worker: null, opened: {}, tile: null, picture: null, since: 0 }));
        this.picture = this.question = null;
    }

    /** Nothing more of the picture is drawn. */
    stop() {
        this.picture?.reject(new Replaced());
        this.picture = null;
        for (const each of this.workers)
            if (each.tile && each.picture.kind === "picture" && performance.now() - each.since > SOON)
                this.end(each);
    }

    /**
     * Casts one picture, and stops the one before.
     * @param {Opened} opened
     * @param {Pass} pass
     * @param {(tile: object, done: {pixels: Uint8ClampedArray<ArrayBuffer>, view: number[], race?: object}) => void} onTile
     * @returns {Promise<void>} when all of it is there
     */
    cast(opened, pass, onTile) {
        this.stop();
        return this.begin("picture", opened, tilesOf(pass), onTile);
    }

    /** The story of a pixel, besides the picture: what cast.c prints. */
    explain(opened, pass, pixel) {
        this.question?.reject(new Replaced());
        let story;
        return this.begin("question", opened, [{ ...pass, explained: pixel }], (_, done) => { ({ story } = done); }).then(() => story);
    }

    begin(kind, opened, tiles, onTile) {
        return new Promise((resolve, reject) => {
            this[kind] = { kind, opened, tiles, left: tiles.length, resolve, reject, onTile };
            for (const each of this.workers)
                if (each.tile === null)
                    this.next(each);
        });
    }

    next(each) {
        const picture = [this.question, this.picture].find((one) => one?.tiles.length > 0), tile = picture?.tiles.shift();
        if (tile === undefined)
            return;
        if (each.worker === null) {
            const worker = each.worker = this.start();
            each.opened = {};
            worker.addEventListener("message", ({ data }) => each.worker === worker && this.hear(each, data));
            worker.addEventListener("error", (event) => { event.preventDefault(); this.hear(each, { failed: event.message || "a Worker did not start" }); });
        }
        Object.assign(each, { tile, picture, since: performance.now(), timer: setTimeout(() => {
            this.end(each);
            this.hear(each, { failed: `your code did not end within ${LONGEST / 1000} seconds` });
        }, LONGEST) });
        const { program, scene } = picture.opened, is = each.opened;
        each.worker.postMessage({ program: is.program === program ? null : program, scene: is.scene === scene && is.program === program ? null : scene, tile });
        each.opened = picture.opened;
    }

    hear(each, done) {
        const { tile, picture } = each;
        clearTimeout(each.timer);
        each.tile = null;
        if (done.failed !== undefined)
            each.opened = {};
        if (picture === this[picture.kind]) {
            if (done.failed !== undefined) {
                this[picture.kind] = null;
                picture.reject(new Error(done.failed));
            } else {
                picture.onTile(tile, done);
                if (--picture.left === 0) {
                    this[picture.kind] = null;
                    picture.resolve();
                }
            }
        }
        this.next(each);
    }

    end(each) {
        clearTimeout(each.timer);
        each.worker?.terminate();
        each.worker = each.tile = null;
    }

    /** The Workers end, and their memory is free; the next picture starts them again. */
    sleep() {
        this.stop();
        this.workers.forEach((each) => this.end(each));
    }
}
