// style.test.mjs - the page's code has one style, nothing in it is unused, and its types fit (chapters/book/types.d.ts). FIX=1 mends what can be mended.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { createRequire } from "node:module";
import test from "node:test";

const require = createRequire(new URL("../../../chapters/book/package.json", import.meta.url));
const { ESLint } = require("eslint"), js = require("@eslint/js"), globals = require("globals");
const { default: stylistic } = await import(require.resolve("@stylistic/eslint-plugin"));

const style = {
    "arrow-parens": "always", "brace-style": ["1tbs", { allowSingleLine: true }], "comma-spacing": [], "eol-last": [], "keyword-spacing": [],
    indent: [4, { SwitchCase: 1, ignoredNodes: ["TemplateLiteral *", "ConditionalExpression"] }], "max-len": [{ code: 180, ignoreTemplateLiterals: true, ignoreStrings: true, ignoreRegExpLiterals: true }],
    "no-trailing-spaces": [], "nonblock-statement-body-position": "below", "object-curly-spacing": "always",
    quotes: ["double", { avoidEscape: true, allowTemplateLiterals: "always" }], semi: [], "space-infix-ops": [],
};
const config = [js.configs.recommended, {
    languageOptions: { globals: { ...globals.browser, ...globals.node, ...globals.serviceworker } },
    plugins: { "@stylistic": stylistic },
    rules: {
        ...Object.fromEntries(Object.entries(style).map(([name, how]) => [`@stylistic/${name}`, ["error", ...[how].flat()]])),
        eqeqeq: "error", "no-var": "error", "prefer-const": ["error", { destructuring: "all" }],
    },
}];

const tracked = (...patterns) => execFileSync("git", ["ls-files", ...patterns], { encoding: "utf8" }).trim().split("\n");
test("the page's code has one style", async () => {
    const fix = process.env.FIX === "1", eslint = new ESLint({ overrideConfigFile: true, overrideConfig: config, fix });
    const results = await eslint.lintFiles(tracked("chapters/book/*js", "tests/proof/book/*js"));
    if (fix)
        await ESLint.outputFixes(results);
    const found = results.flatMap(({ filePath, messages }) => messages.map(({ line, message }) => `${filePath}:${line}: ${message}`));
    assert.deepEqual(found, []);
});

test("the page's code names only what there is", () => {
    const how = "--allowJs --checkJs --noEmit --skipLibCheck --target esnext --lib esnext,dom,dom.iterable --module esnext --moduleResolution bundler --types node --pretty false";
    const files = tracked("chapters/book/*js", "chapters/book/types.d.ts", ":!chapters/book/compiler");
    const { stdout } = spawnSync("node", [require.resolve("typescript/bin/tsc"), ...how.split(" "), "--typeRoots", "chapters/book/node_modules/@types", ...files], { encoding: "utf8" });
    assert.deepEqual(stdout.split("\n").filter(Boolean), []);
});
