// scene_view.js - a canvas that shows a scene, cast by a program in a pool of Workers: from coarse to fine, and coarse
// again while the camera moves. Turned by mouse, finger and key.
import { unzipped } from "../worker_questions.js";
import { Pool, Replaced } from "./pool.js";
import { fly, numbersOf, orbit, viewOf, zoom } from "./scene.js";

const FRAME = 28; // milliseconds of a frame while something moves
const KEYS = {
    ArrowLeft: (view) => orbit(view, -5, 0), ArrowRight: (view) => orbit(view, 5, 0), ArrowUp: (view) => orbit(view, 0, 5), ArrowDown: (view) => orbit(view, 0, -5),
    "+": (view) => zoom(view, 0.92), "=": (view) => zoom(view, 0.92), "-": (view) => zoom(view, 1 / 0.92),
    w: (view) => fly(view, 0, 0, 0.05), s: (view) => fly(view, 0, 0, -0.05), a: (view) => fly(view, -0.05, 0, 0), d: (view) => fly(view, 0.05, 0, 0),
    q: (view) => fly(view, 0, -0.05, 0), e: (view) => fly(view, 0, 0.05, 0),
};

/**
 * @typedef {object} Told what the page is told
 * @property {(view: object) => void} [onView] the camera has moved
 * @property {(words: string) => void} [onTrouble] why there is no picture; none: there is one
 * @property {(fine: boolean, milliseconds: number) => void} [onPicture] a picture is complete; not fine: while it moves
 * @property {(pixel: {column: number, row: number}) => void} [onPoint] a pixel was chosen
 */
export class SceneView {
    /**
     * @param {HTMLCanvasElement} canvas of the size of the fine picture
     * @param {import("./pool.js").Pool} pool
     * @param {{samples?: number, depth?: number} & Told} given samples: in each direction of a pixel, in the end
     */
    constructor(canvas, pool, { samples = 1, depth = 5, ...told }) {
        this.canvas = canvas;
        this.pool = pool;
        this.samples = samples;
        this.depth = depth;
        this.told = told;
        this.caster = "";
        this.mistake = -1; // mistaken.c
        this.context = canvas.getContext("2d");
        this.divided = 4; // a picture that moves has a pixel for so many columns and rows
        this.version = 0;
        this.listen();
    }

    /** From now on another program, or another scene. keepsView: the camera stays where it is. */
    show({ program = this.opened?.program, scene = this.opened?.scene, keepsView = false }) {
        const isOther = program !== this.opened?.program;
        this.opened = { program, scene };
        if (!keepsView)
            this.view = null; // until the first tile says it
        return program && scene ? this.draw(isOther) : undefined; // the other one is on its way
    }

    /** The camera moves. */
    look(view) {
        this.view = view;
        this.told.onView?.(view);
        this.draw();
    }

    /** Draws until the picture is fine. A coarse picture that is being drawn is completed first, or what moves would never be seen. */
    draw(atOnce = false) {
        this.version++;
        if (this.isFine || atOnce)
            this.pool.stop();
        return this.running ??= this.run().finally(() => { this.running = null; });
    }

    async run() {
        for (let version = -1; version !== this.version;) {
            version = this.version;
            try {
                await this.drawOnce(version);
            } catch (reason) {
                if (!(reason instanceof Replaced))
                    this.told.onTrouble?.(reason.message);
            }
        }
    }

    /** From coarse to fine, unless there is a newer one. */
    async drawOnce(version) {
        const start = performance.now(), took = () => performance.now() - start;
        this.isFine = false;
        const isSeen = !this.canvas.hidden; // if not, only the fine picture is needed
        if (isSeen) {
            await this.cast(this.pass(this.divided));
            this.told.onTrouble?.("");
            this.told.onPicture?.(false, took());
            this.divided = took() > FRAME ? Math.min(16, 2 * this.divided) : took() < FRAME / 6 ? Math.max(2, this.divided / 2) : this.divided;
            await new Promise((resolve) => requestAnimationFrame(resolve));
            if (version !== this.version)
                return;
        }
        this.isFine = true;
        for (const pass of isSeen ? this.finer() : this.finer().slice(-1))
            await this.cast(pass);
        this.told.onTrouble?.("");
        this.told.onPicture?.(true, took());
    }

    pass(divided, samples = 1) {
        const { width, height } = this.canvas, view = this.view && numbersOf(this.view);
        return { width: Math.ceil(width / divided), height: Math.ceil(height / divided), samples, depth: this.depth, view, caster: this.caster, mistake: this.mistake };
    }

    /** The last pass has all samples: a picture of its size with one would take a quarter of its time, and be seen for a moment. */
    finer() {
        const passes = [];
        for (let divided = this.divided / 2; divided >= 1; divided /= 2)
            passes.push(this.pass(divided, divided === 1 ? this.samples : 1));
        return passes;
    }

    /** Tiles of a fine picture appear as they come; those of a coarse one together, or it would tear. */
    async cast(pass) {
        const { width, height } = this.canvas, isWhole = pass.width === width && pass.height === height;
        const small = isWhole ? null : new OffscreenCanvas(pass.width, pass.height).getContext("2d");
        await this.pool.cast(this.opened, pass, ({ left, top, right, bottom }, { pixels, view }) => {
            this.view ??= viewOf(view);
            (small ?? this.context).putImageData(new ImageData(pixels, right - left, bottom - top), left, top);
        });
        if (small)
            this.context.drawImage(small.canvas, 0, 0, width, height);
    }

    // ---- mouse, finger, keys -------------------------------------------------------------------

    listen() {
        const { canvas } = this, pointers = new Map();
        let far = 0, moved = 0;
        const apart = () => { const [a, b] = [...pointers.values()]; return Math.hypot(a.x - b.x, a.y - b.y); };
        canvas.addEventListener("pointerdown", (event) => {
            if (!this.view)
                return;
            canvas.setPointerCapture(event.pointerId);
            pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
            far = pointers.size === 2 ? apart() : 0;
            moved = 0;
        });
        canvas.addEventListener("pointermove", (event) => {
            const before = pointers.get(event.pointerId);
            if (!before)
                return;
            const dx = event.clientX - before.x, dy = event.clientY - before.y, turn = 200 / canvas.clientHeight;
            moved += Math.abs(dx) + Math.abs(dy);
            pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
            if (pointers.size === 2) {
                const now = apart();
                this.look(zoom(this.view, far / now));
                far = now;
            } else if (event.shiftKey) {
                const step = 0.8 / canvas.clientHeight;
                this.look(fly(this.view, -step * dx, step * dy, 0));
            } else if (moved > 3) {
                this.look(orbit(this.view, -turn * dx, turn * dy));
            }
        });
        canvas.addEventListener("pointercancel", ({ pointerId }) => pointers.delete(pointerId));
        canvas.addEventListener("pointerup", ({ pointerId, offsetX, offsetY }) => {
            if (pointers.delete(pointerId) && moved <= 3)
                this.told.onPoint?.({ column: Math.floor(offsetX * canvas.width / canvas.clientWidth), row: Math.floor(offsetY * canvas.height / canvas.clientHeight) });
        });
        canvas.addEventListener("wheel", (event) => {
            if (!this.view || document.activeElement !== canvas && !event.ctrlKey)
                return; // the page scrolls, until the picture is chosen
            event.preventDefault();
            this.look(zoom(this.view, Math.exp(Math.sign(event.deltaY) * Math.min(0.2, Math.abs(event.deltaY) / 500))));
        }, { passive: false });
        canvas.addEventListener("keydown", (event) => {
            const change = KEYS[event.key];
            if (!change || !this.view || event.ctrlKey || event.metaKey || event.altKey)
                return;
            event.preventDefault();
            this.look(change(this.view));
        });
    }
}

// ---- what a page needs to show one ----------------------------------------------------------------

/** A scene of the site. */
export const sceneOf = async (name) => new TextDecoder().decode(await unzipped(`scenes/${name}.nff.gz`));

/** A view on a canvas, which sleeps while nobody sees it. */
export function openView(canvas, site, told) {
    const pool = new Pool(() => new Worker(new URL("cast_worker.js", site), { type: "module" }));
    const view = new SceneView(canvas, pool, told);
    document.addEventListener("visibilitychange", () => {
        if (document.visibilityState === "hidden")
            pool.sleep();
        else if (view.opened)
            view.draw();
    });
    return view;
}
