// pool.js - a pool of Workers that cast a picture tile by tile. Nothing is shared: each has its own instance of the program.

const LONGEST = 30_000; // milliseconds for a tile; a wrong answer may need any time, a busy machine more than an idle one
const TILE = { width: 64, height: 48 };

/** The picture was stopped: there is another one, or a new scene. */
export class Replaced extends Error {}

/** The tiles of a pass, in reading order. */
function tilesOf(pass) {
    const { width, height } = pass, tiles = [];
    for (let top = 0; top < height; top += TILE.height)
        for (let left = 0; left < width; left += TILE.width)
            tiles.push({ ...pass, left, top, right: Math.min(width, left + TILE.width), bottom: Math.min(height, top + TILE.height) });
    return tiles;
}

export class Pool {
    /**
     * @param {() => Worker} start
     * @param {number} size
     */
    constructor(start, size = Math.min(16, navigator.hardwareConcurrency || 2)) {
        this.start = start;
        this.workers = Array.from({ length: size }, () => ({ worker: null, opened: null, tile: null }));
        this.opened = null;
        this.picture = null;
    }

    /** From now on pictures are of this scene, by this program. */
    open(program, scene) {
        this.stop();
        this.opened = { program, scene };
    }

    /** Nothing more of the picture is drawn. */
    stop() {
        this.picture?.reject(new Replaced());
        this.picture = null;
    }

    /**
     * Casts one picture, and stops the one before.
     * @param {{width: number, height: number, samples: number, depth: number, view: number[] | null}} pass
     * @param {(tile: object, pixels: Uint8ClampedArray, view: number[]) => void} onTile
     * @returns {Promise<void>} when all of it is there
     */
    cast(pass, onTile) {
        this.stop();
        return new Promise((resolve, reject) => {
            const tiles = tilesOf(pass);
            this.picture = { tiles, left: tiles.length, resolve, reject, onTile };
            for (const each of this.workers)
                if (each.tile === null)
                    this.next(each);
        });
    }

    next(each) {
        const tile = this.picture?.tiles.shift();
        if (tile === undefined)
            return;
        if (each.worker === null) {
            each.worker = this.start();
            each.opened = null;
            each.worker.addEventListener("message", ({ data }) => this.hear(each, data));
            each.worker.addEventListener("error", (event) => { event.preventDefault(); this.hear(each, { failed: event.message || "a Worker did not start" }); });
        }
        each.tile = tile;
        each.picture = this.picture;
        each.timer = setTimeout(() => {
            each.worker.terminate();
            each.worker = null;
            this.hear(each, { failed: `your code did not end within ${LONGEST / 1000} seconds` });
        }, LONGEST);
        each.worker.postMessage({ opened: each.opened === this.opened ? null : this.opened, tile });
        each.opened = this.opened;
    }

    hear(each, { pixels, view, failed }) {
        const { tile, picture } = each;
        clearTimeout(each.timer);
        each.tile = null;
        if (failed !== undefined)
            each.opened = null;
        if (picture === this.picture && picture !== null) {
            if (failed !== undefined) {
                this.picture = null;
                picture.reject(new Error(failed));
            } else {
                picture.onTile(tile, pixels, view);
                if (--picture.left === 0) {
                    this.picture = null;
                    picture.resolve();
                }
            }
        }
        this.next(each);
    }

    /** The Workers end, and their memory is free; the next picture starts them again. */
    sleep() {
        this.stop();
        for (const each of this.workers) {
            clearTimeout(each.timer);
            each.worker?.terminate();
            each.worker = each.tile = null;
        }
    }
}
