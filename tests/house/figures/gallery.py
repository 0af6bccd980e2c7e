"""gallery.py - the page of pictures and figures, as a browser shows it: gallery.py PAGE"""
import os
import sys
from urllib.parse import unquote

from browser import Browser
from check import Checks

checks = Checks("the page")
page = os.path.abspath(sys.argv[1])
figures = int(sys.argv[2])  # how many it has to show

# Every visible piece of text, and its contrast with its background.
CONTRAST = """
(() => {
    const parts = text => text.match(/[\\d.]+/g).map(Number);
    const linear = c => (c /= 255, c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
    const light = c => 0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]);
    const ground = e => {
        for (; e; e = e.parentElement) {
            const c = parts(getComputedStyle(e).backgroundColor);
            if (c.length < 4 || c[3] === 1) return c;
        }
        return matchMedia('(prefers-color-scheme: dark)').matches ? [18, 18, 18] : [255, 255, 255];
    };
    const found = [];
    const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walk.nextNode()) {
        const e = walk.currentNode.parentElement;
        if (!walk.currentNode.data.trim() || !e.getClientRects().length) continue;
        const [a, b] = [light(parts(getComputedStyle(e).color)), light(ground(e))].sort((x, y) => x - y);
        found.push([(b + 0.05) / (a + 0.05), walk.currentNode.data.trim().slice(0, 40)]);
    }
    return found;
})()
"""
ALL_DECODED = """
(async () => {
    const broken = [];
    for (const image of document.images) {
        image.loading = 'eager';
        try { await image.decode(); } catch (e) { broken.push(image.src); continue; }
        if (!image.naturalWidth) broken.push(image.src);
    }
    return broken;
})()
"""
REACHED = """
(() => {
    const e = document.activeElement;
    if (!e || e === document.body) return null;
    const style = getComputedStyle(e), box = e.getBoundingClientRect();
    const all = [...document.querySelectorAll('a[href], summary, video')].filter(e => e.getClientRects().length);
    return {
        place: all.indexOf(e), of: all.length, words: e.textContent.trim().slice(0, 40) || e.ariaLabel || e.href || '',
        outlined: style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2,
        shown: box.width > 0 && box.bottom > 0 && box.top < innerHeight && box.right > 0 && box.left < innerWidth,
    };
})()
"""


def holds(browser, width, scheme):
    where = f"{width} px wide, {scheme}"
    browser.screen(width, scheme=scheme)
    browser.open("file://" + page)
    for opened in (False, True):
        if opened:
            browser.value("document.querySelectorAll('details').forEach(d => d.open = true)")
        broken = browser.value(ALL_DECODED)
        checks.that(f"{where}: no picture is broken", broken == [], str(broken))
        across = browser.value("[document.documentElement.scrollWidth, innerWidth]")
        checks.that(f"{where}: nothing has to be scrolled sideways", across[0] <= across[1] == width, str(across))
        text = browser.value(CONTRAST)
        checks.that(f"{where}: there is text", len(text) > 20)
        checks.that(f"{where}: all text has a contrast of 4.5", min(text)[0] >= 4.5, str(sorted(text)[:3]))
    wanted = ("-4x3" if width <= 600 else "") + ("-dark.svg" if scheme == "dark" else ".svg")
    shown = browser.value("[...document.images].map(i => i.currentSrc).filter(s => s.includes('/figures/'))")
    checks.that(f"{where}: every figure is there", len(shown) == figures, str(shown))
    checks.that(f"{where}: in its theme and shape",
                all(s.endswith("/" + s.split("/")[-2] + wanted) for s in shown), str(shown))
    small = browser.value("[...document.images].filter(i => i.width < 0.9 * Math.min(innerWidth, 500)).map(i => i.src)")
    checks.that(f"{where}: no picture is small", small == [], str(small))
    asked = [e["params"]["request"]["url"] for e in browser.events if e.get("method") == "Network.requestWillBeSent"]
    checks.that(f"{where}: nothing comes from a network", all(a.startswith(("file:", "data:")) for a in asked), str(asked))
    said = [e["params"] for e in browser.events
            if e.get("method") in ("Log.entryAdded", "Runtime.consoleAPICalled", "Runtime.exceptionThrown")]
    checks.that(f"{where}: the console has nothing to say", said == [], str(said))


def keyboard(browser, scheme):
    """Tab reaches every link, in the order in which they stand, and one sees where it is."""
    browser.screen(900, scheme=scheme)
    browser.open("file://" + page)
    browser.value("document.querySelectorAll('details').forEach(d => d.open = true)")
    places, count, presses = [], None, 0
    while count is None or len(places) <= count:
        browser.press("Tab", 9)
        presses += 1
        reached = browser.value(REACHED)
        if reached is not None and places and reached["place"] == places[-1] and presses < 5000:
            continue  # inside a video, on one of its controls
        if reached is None or reached["place"] in places:
            break
        count = reached["of"]
        places.append(reached["place"])
        checks.that(f"{scheme}: where the keyboard is, is seen: {reached['words']}",
                    reached["outlined"] and reached["shown"], str(reached))
    checks.that(f"{scheme}: the keyboard reaches every link, in order", places == list(range(count or -1)),
                f"{places} of {count}")


def structure(browser):
    """The structure that a screen reader uses."""
    browser.screen(900)
    browser.open("file://" + page)
    checks.that("the language is given", browser.value("document.documentElement.lang") == "en")
    checks.that("there is a title", browser.value("document.title.length") > 10)
    for landmark in ("main", "header", "nav[aria-label]", "h1"):
        checks.that(f"there is one {landmark}", browser.value(f"document.querySelectorAll('{landmark}').length") == 1)
    levels = browser.value("[...document.querySelectorAll('h1, h2, h3, h4')].map(h => +h.tagName[1])")
    checks.that("no level of headings is left out",
                levels[0] == 1 and all(b - a <= 1 for a, b in zip(levels, levels[1:])), str(levels))
    silent = browser.value("[...document.images].filter(i => i.alt.length < 20).map(i => i.src)")
    checks.that("every picture is described in words", silent == [], str(silent))
    jumps = browser.value("[...document.images].filter(i => !i.getAttribute('width') || !i.getAttribute('height')).map(i => i.src)")
    checks.that("and has a size before it is there", jumps == [], str(jumps))
    links = browser.value("[...document.links].map(a => [a.getAttribute('href'), a.textContent.trim() || a.querySelector('img').alt])")
    for href, _ in links:
        there = browser.value(f"document.getElementById('{href[1:]}') !== null") if href.startswith("#") else \
            os.path.exists(os.path.join(os.path.dirname(page), unquote(href)))
        checks.that(f"{href} leads somewhere", there)
    names = {}
    for href, name in links:
        names.setdefault(name, set()).add(href)
    twice = {name: sorted(hrefs) for name, hrefs in names.items() if len(hrefs) > 1}
    checks.that("two links that sound the same lead to the same", twice == {}, str(twice))
    twice = browser.value("[...document.querySelectorAll('[id]')].map(e => e.id).filter((id, i, all) => all.indexOf(id) !== i)")
    checks.that("no id is used twice", twice == [], str(twice))


chromium = Browser()
try:
    for color_scheme in ("light", "dark"):
        for pixels in (320, 360, 768, 1440):
            holds(chromium, pixels, color_scheme)
        keyboard(chromium, color_scheme)
    structure(chromium)
finally:
    chromium.close()
checks.end()
