// types.d.ts - what tsc cannot know: names that are written when the site is built, and what browsers have besides.
// An element that was found in the page may be of any kind.
declare const COURSE: any, FILES: Record<string, string>, ORDER: string[];
declare const registration: any, clients: any, skipWaiting: () => Promise<void>;
declare function takeEarlyClicks(): void;
interface ParentNode { querySelector(selector: string): any; querySelectorAll(selector: string): any; }
interface Document { getElementById(id: string): any; }
interface EventTarget { dataset?: any; closest?: any; matches?: any; localName?: any; files?: any; value?: any; focus?: any; blur?: any; }
interface Event { waitUntil?: any; respondWith?: any; request?: any; }
interface Navigator { userAgentData?: { platform: string }; connection?: { saveData: boolean }; }
declare module "node:fs" { interface Dirent<Name> { path: Name; } }
