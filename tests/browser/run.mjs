// SPDX-License-Identifier: MIT
// Runs the tests of one file, or of all, with node's own test runner:
//   FLIPBOOK=build/release/flipbook node tests/browser/run.mjs [NAME...]
// Without a browser there is nothing to drive: exit 77, which ctest counts as skipped.
import { readdirSync } from "node:fs";

import { findBrowser } from "./chromium.mjs";

if (!findBrowser()) {
  console.log("Skipped: no browser was found. Install chromium-headless-shell, or name one in FLIPBOOK_BROWSER.");
  process.exit(77);
}
const all = readdirSync(new URL(".", import.meta.url))
  .filter((f) => f.endsWith("_test.mjs"))
  .sort();
const wanted = process.argv.slice(2).map((name) => `${name}_test.mjs`);
for (const file of wanted.length ? wanted : all) await import(`./${file}`);
