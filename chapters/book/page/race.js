// race.js - the same picture by both orders of chapter 06 and by chapter 08's engines: when each pixel got its color, and how
// often it was asked whether its ray hits a sphere.
import { Pool } from "../cast/pool.js";
import { element } from "./verdict.js";

export const RACERS = { "image order": "every pixel asks every sphere", "object order": "every sphere asks every pixel", object: "every sphere asks its rectangle",
    bvh: "every ray asks the spheres on its way", packet: "16 rays ask together", tiles: "a tile asks for all its rays", bins: "near spheres ask first" };
const SIZE = { width: 160, height: 120 }, COUNT = SIZE.width * SIZE.height;
const SHOWN = 3000; // milliseconds that the slowest takes to be seen

/** From black by red and yellow to white: red, green, blue. */
const heat = (part) => [2.5 * part, 2.5 * part - 0.9, 4 * part - 3].map((x) => 255 * Math.max(0, Math.min(1, x)));
const numberOf = (x) => x < 10 ? x.toFixed(1) : Math.round(x).toLocaleString("en");

/**
 * @param {object} given
 * @param {URL} given.site
 * @param {() => Promise<WebAssembly.Module>} given.link the program, whose questions are counted
 * @param {() => {scene: string, view: number[]}} given.seen what is cast
 */
export function setUpRace({ site, link, seen }) {
    const say = element("p", { role: "status" }), list = element("ol", {}), scale = element("canvas", { width: 120, height: 10, "aria-hidden": "true" }), most = element("span", {});
    const section = element("section", { class: "race", hidden: "", "aria-label": "A race" }, say, list, element("p", { class: "scale" }, "How many spheres ask a pixel: 0 ", scale, most));
    let pool = null, version = 0;

    function draw(canvas, colorOf) {
        const context = canvas.getContext("2d"), { width, height } = canvas, image = context.createImageData(width, height);
        for (let i = 0; i < width * height; i++)
            image.data.set(colorOf(i), 4 * i);
        context.putImageData(image, 0, 0);
    }

    /** All begin together, as slowly as is needed to see it. */
    function play(racers, mine) {
        const slowest = Math.max(...racers.map(({ took }) => took)), largest = Math.max(...racers.map(({ counts }) => counts.reduce((a, b) => Math.max(a, b), 1)));
        const part = (count) => Math.log1p(count) / Math.log1p(largest), length = matchMedia("(prefers-reduced-motion: reduce)").matches ? 1 : Math.max(SHOWN, slowest), begin = performance.now();
        draw(scale, (i) => [...heat(i % scale.width / scale.width), 255]);
        most.textContent = ` ${largest.toLocaleString("en")}`;
        say.textContent = length > slowest ? `${numberOf(length / slowest)} times slower than it was.` : "";
        requestAnimationFrame(function frame() {
            const now = Math.min(1, (performance.now() - begin) / length) * slowest;
            if (mine !== version)
                return;
            for (const { took, pixels, painted, counts, picture, asked, words } of racers.filter((each) => !each.isDone)) {
                const isDone = now >= took;
                draw(picture, (i) => isDone || painted[i] > 0 && painted[i] <= now ? pixels.subarray(4 * i, 4 * i + 4) : [0, 0, 0, 0]);
                if (!isDone)
                    continue;
                draw(asked, (i) => [...heat(part(counts[i])), 255]);
                words.textContent = `${numberOf(took)} ms\n${numberOf(counts.reduce((a, b) => a + b) / COUNT)} a pixel`;
                racers.find((each) => each.words === words).isDone = true;
            }
            if (now < slowest)
                requestAnimationFrame(frame);
        });
    }

    async function start() {
        stop();
        const mine = version, racers = [];
        list.replaceChildren();
        section.hidden = false;
        section.scrollIntoView({ block: "nearest" });
        say.textContent = "Linking.";
        const opened = { program: await link(), scene: seen().scene }, { view } = seen();
        if (mine !== version)
            return;
        pool = new Pool(() => new Worker(new URL("cast_worker.js", site), { type: "module" }), 1); // one at a time: they do not wait for each other
        for (const [at, [caster, idea]] of Object.entries(RACERS).entries()) {
            say.textContent = `Casting ${at + 1} of ${Object.keys(RACERS).length}: ${caster}.`;
            const [picture, asked] = [0, 1].map(() => element("canvas", { ...SIZE, "aria-hidden": "true" })), words = element("span", {}, "…");
            list.append(element("li", { title: idea }, picture, asked, element("b", {}, caster), words));
            try {
                const pass = { ...SIZE, samples: 1, depth: 0, view, caster, mistake: -1, isRace: true };
                await pool.cast(opened, pass, (_, { pixels, race }) => racers.push({ ...race, pixels, picture, asked, words }));
            } catch (reason) {
                if (mine !== version)
                    return;
                words.textContent = reason.message;
            }
        }
        pool.sleep();
        if (racers.length > 0)
            play(racers, mine);
    }

    /** Nothing of it goes on; what is shown stays. */
    function stop() {
        version++;
        pool?.sleep();
        if (/^(Casting|Linking)/.test(say.textContent))
            say.textContent = "The race was stopped.";
    }
    return { section, start, stop };
}
