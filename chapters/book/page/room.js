// room.js - the room of a chapter: lesson and exercise side by side with a divider that moves; on a small screen one of
// lesson, code and verdict. early.js has put back what was chosen, before anything was painted.
const root = document.documentElement, $ = (id) => document.getElementById(id);
const LEAST = 25, MOST = 75, A_KEY = 2; // percent
const VIEWS = ["lesson", "code", "verdict"], scrolled = {};

function setUpDivider(divider) {
    const set = (percent) => {
        const lesson = Math.round(Math.max(LEAST, Math.min(MOST, percent)));
        root.style.setProperty("--lesson", String(lesson));
        divider.setAttribute("aria-valuenow", String(lesson));
        try {
            localStorage.setItem("ray-casting lesson", String(lesson));
        } catch {
            // It lasts as long as the page.
        }
    };
    const now = () => Number(root.style.getPropertyValue("--lesson") || 50);
    divider.setAttribute("aria-valuenow", now());
    divider.addEventListener("pointerdown", (event) => {
        divider.setPointerCapture(event.pointerId);
        divider.classList.add("held");
        event.preventDefault();
        divider.focus();
    });
    divider.addEventListener("pointermove", ({ pointerId, clientX }) => {
        const { left, width } = divider.parentElement.getBoundingClientRect();
        if (divider.hasPointerCapture(pointerId))
            set((clientX - left) / width * 100);
    });
    divider.addEventListener("lostpointercapture", () => divider.classList.remove("held"));
    divider.addEventListener("dblclick", () => set(50));
    divider.addEventListener("keydown", (event) => {
        const way = { ArrowLeft: now() - A_KEY, ArrowRight: now() + A_KEY, Home: LEAST, End: MOST, Enter: 50 }[event.key];
        if (way !== undefined) {
            event.preventDefault();
            set(way);
        }
    });
}

/** Tabs by mouse and arrow keys; choose(tab) shows what belongs to it. */
export function setUpTabs(tabs, choose) {
    tabs.forEach((tab, at) => {
        tab.addEventListener("click", () => choose(tab));
        tab.addEventListener("keydown", ({ key }) => {
            const next = tabs[(at + { ArrowRight: 1, ArrowLeft: tabs.length - 1 }[key]) % tabs.length];
            if (next) {
                choose(next);
                next.focus();
            }
        });
    });
}
export function selectTab(tabs, chosen) {
    for (const tab of tabs) {
        tab.setAttribute("aria-selected", String(tab === chosen));
        tab.tabIndex = tab === chosen ? 0 : -1;
    }
}

const tabsOfViews = () => VIEWS.map((view) => $(`view-${view}`));

/** Shows the lesson, the code or the verdict, if there is no room for all. Each comes back where it was left. */
export function showView(view) {
    const before = root.dataset.view;
    if (before !== view)
        scrolled[before] = scrollY;
    root.dataset.view = view;
    selectTab(tabsOfViews(), $(`view-${view}`));
    if (before !== view && getComputedStyle($("views")).display !== "none")
        scrollTo({ top: scrolled[view] ?? 0, behavior: "instant" });
}

export function setUpRoom() {
    setUpDivider($("divider"));
    showView(root.dataset.view);
    setUpTabs(tabsOfViews(), (tab) => showView(tab.id.replace("view-", "")));
    addEventListener("click", ({ target }) => {
        if (target.closest?.('a[href="#exercise"]'))
            showView("code");
    }, true); // before the link is followed
    // Where a keyboard covers the page instead of making it smaller.
    globalThis.visualViewport?.addEventListener("resize", () => root.style.setProperty("--seen", `${visualViewport.height}px`));
}
