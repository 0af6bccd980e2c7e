// open_view.js - what a page needs to show a scene: a pool of Workers, the program of the reference, a scene of the site.
import { Pool } from "./pool.js";
import { SceneView } from "./scene_view.js";

export async function fetched(site, name) {
    const response = await fetch(new URL(name, site));
    if (!response.ok)
        throw new Error(`${name} could not be fetched: the host says ${response.status}`);
    return response;
}

/** A compressed text of the site. */
export const unzipped = async (site, name) => new Response((await fetched(site, name)).body.pipeThrough(new DecompressionStream("gzip"))).text();
export const sceneOf = (site, name) => unzipped(site, `scenes/${name}.nff.gz`);

/** The program with the reference's answers. */
export const referenceProgram = async (site) => WebAssembly.compileStreaming(await fetched(site, "programs/cast.wasm"));

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

/** The picture as a PNG file, for the student. */
export function save(canvas, name) {
    canvas.toBlob((blob) => {
        const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: name });
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
    });
}
