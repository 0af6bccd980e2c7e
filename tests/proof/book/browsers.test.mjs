// browsers.test.mjs - a browser that is missing is named, with the way to get it, and there is no stack trace.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { chmodSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";

const folder = mkdtempSync(join(tmpdir(), "book-"));
test.after(() => rmSync(folder, { recursive: true }));
const ask = (...browsers) => {
    const { status, stderr } = spawnSync(process.execPath, ["tests/proof/book/browsers.mjs", ...browsers], { env: { PATH: folder }, encoding: "utf8" });
    return [status, stderr];
};

test("without browsers each is named", () => {
    assert.deepEqual(ask("chromium", "firefox"), [1,
        "check-book: Chromium is missing (no chromium, chromium-browser, google-chrome in PATH): 'make setup FOR=contributor' installs it\n" +
        "check-book: Firefox is missing (no firefox-esr, firefox in PATH): 'make setup FOR=contributor' installs it\n"]);
});

test("if one is there, the tests can run without the other", () => {
    writeFileSync(join(folder, "chromium"), "");
    chmodSync(join(folder, "chromium"), 0o755);
    assert.deepEqual(ask("chromium"), [0, ""]);
    assert.deepEqual(ask("chromium", "firefox"), [1,
        "check-book: Firefox is missing (no firefox-esr, firefox in PATH): 'make setup FOR=contributor' installs it, and 'make check-book BROWSERS=chromium' tests without it\n"]);
    assert.deepEqual(ask("lynx"), [1, "check-book: BROWSERS=lynx: expected chromium or firefox\n"]);
});
