// SPDX-License-Identifier: MIT
// The page of `flipbook gallery`, opened from the disk: it loads nothing from elsewhere, fits every width, works by keyboard,
// tells what it shows, stays still for who wants that, and its sliders change the picture. FLIPBOOK_SHOTS names a folder for
// pictures of the page.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { pathToFileURL } from "node:url";

import { Browser } from "./chromium.mjs";
import { contrasts } from "./layout.mjs";
import { flipbook } from "./program.mjs";

const folder = mkdtempSync(join(tmpdir(), "flipbook-gallery-"));
const page = pathToFileURL(join(folder, "g/index.html")).href;
const sent = join(folder, "sent.html");
let browser;

writeFileSync(
  join(folder, "sliding.toml"),
  `title = "A title that is long enough to be broken on a telephone, with <b>marks</b> & signs"
scene = "dam_break"
grid.cells = [24, 24]
[[variant]]
transfer.scheme = "pic"
[[variant]]
transfer.scheme = "flip"
[[key]]
t = 0.4
over = 0.2
label = "FLIP slides to PIC"
transfer.flip_ratio = 0
[output]
fps = 10
duration = 1.2
size = [640, 360]
`,
);
writeFileSync(
  join(folder, "g.toml"),
  `title = "A gallery"
intro = "What it is about."
[[entry]]
study = "sliding.toml"
text = "Look at the second pane."
[[entry]]
scrub = "dam_break"
vary = "transfer.flip_ratio"
values = [0, 0.5, 0.9, 1]
frames = 6
set = { grid.cells = [24, 24], output.duration = 1 }
[[entry]]
figure = "kernels"
`,
);

before(() => {
  execFileSync(flipbook, ["gallery", "g", "--from", "g.toml", "-q"], { cwd: folder });
  execFileSync(flipbook, ["gallery", "g", "--from", "g.toml", "-q", "--inline"], { cwd: folder });
  renameSync(join(folder, "g/index.html"), sent);
  execFileSync(flipbook, ["gallery", "g", "--from", "g.toml", "-q"], { cwd: folder });
  browser = new Browser();
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
});

const loaded = "document.querySelector('.scrubber').dataset.loaded !== undefined";
const shown = "document.querySelector('.scrubber .screen img').currentSrc.slice(-9)";

/// Scrolls through the page once, so that everything that waits for that is loaded.
async function walk(tab) {
  await tab.evaluate(`(async () => { for (const e of document.querySelectorAll('.piece')) { e.scrollIntoView({ behavior: 'instant' }); await new Promise((r) => setTimeout(r, 150)); } })()`);
  await tab.until(loaded, "the pictures of the scrubber");
  await tab.evaluate("window.scrollTo({ top: 0, behavior: 'instant' })");
}

function shots(name) {
  if (!process.env.FLIPBOOK_SHOTS) return undefined;
  mkdirSync(process.env.FLIPBOOK_SHOTS, { recursive: true });
  return join(process.env.FLIPBOOK_SHOTS, `${name}.png`);
}

test("loads nothing but its own files, and complains about nothing", async () => {
  const tab = await browser.open(page);
  await walk(tab);
  const own = pathToFileURL(join(folder, "g")).href;
  for (const address of tab.requests)
    assert.ok(address.startsWith(own) || address.startsWith("data:"), `the page asked for ${address}`);
  assert.ok(tab.requests.length > 24, "the pictures behind the sliders were asked for");
  assert.deepEqual(tab.errors, []);
});

test("fits windows of any width", async () => {
  for (const dark of [false, true])
    for (const width of [360, 768, 1280, 1920]) {
      const tab = await browser.open(page, { width, height: 800, dark });
      await walk(tab);
      const wide = await tab.evaluate(`(() => { const w = document.documentElement.clientWidth;
        return [...document.querySelectorAll('body *')].filter((e) => !e.closest('.scrolls, pre, .skip') && e.checkVisibility() && e.getBoundingClientRect().right > w + 0.5)
          .map((e) => e.outerHTML.slice(0, 80)); })()`);
      assert.deepEqual(wide, [], `at ${width} something sticks out`);
      assert.ok(await tab.evaluate("document.documentElement.scrollWidth <= document.documentElement.clientWidth"));
      const broken = await tab.evaluate("[...document.images].filter((i) => !i.complete || !i.naturalWidth).map((i) => i.src)");
      assert.deepEqual(broken, [], "every picture is there");
      const file = shots(`${dark ? "dark" : "light"}_${width}`);
      if (file) await tab.screenshotOfAll(file);
      await tab.close();
    }
});

test("can be read: contrasts, names, order of headings", async () => {
  for (const dark of [false, true]) {
    const tab = await browser.open(page, { dark });
    for (const { text, ratio } of await contrasts(tab)) assert.ok(ratio >= 4.5, `"${text}" has a contrast of ${ratio.toFixed(2)}`);
  }
  const tab = await browser.open(page);
  const nameless = await tab.evaluate(`[...document.querySelectorAll('img, video, input, button, [role=region]')].filter((e) => {
    const label = e.getAttribute('aria-label') || e.alt || e.closest('label')?.textContent || e.textContent;
    return !label.trim(); }).map((e) => e.outerHTML.slice(0, 100))`);
  assert.deepEqual(nameless, []);
  assert.match(await tab.evaluate("document.querySelector('video').getAttribute('aria-label')"), /2 panes side by side: PIC, FLIP 1\. Particles are coloured by speed/);
  assert.equal(await tab.evaluate("document.querySelectorAll('h1').length"), 1);
  assert.equal(await tab.evaluate("new Set([...document.querySelectorAll('[id]')].map((e) => e.id)).size === document.querySelectorAll('[id]').length"), true);
  assert.equal(await tab.evaluate("document.querySelectorAll('b').length"), 0, "marks in a title stay text");
  assert.equal(await tab.evaluate("[...document.querySelectorAll('nav a')].every((a) => document.querySelector(a.hash))"), true);
});

test("the sliders choose the picture, by keyboard and by pointer", async () => {
  const tab = await browser.open(page, { reduced: true }); // nothing scrolls by itself
  await walk(tab);
  assert.equal(await tab.evaluate(shown), "0003.webp", "value 0, half-time");
  await tab.evaluate("document.querySelector('input.value').focus()");
  await tab.key("ArrowRight");
  await tab.until(`${shown} === '0009.webp'`, "value 1 at the same moment");
  assert.match(await tab.evaluate("document.querySelector('input.value').getAttribute('aria-valuetext')"), /^0\.5: FLIP 0\.5$/);
  assert.match(await tab.evaluate("document.querySelector('.scrubber img').alt"), /^FLIP 0\.5 at 0\.58 s\./);
  await tab.key("End");
  await tab.until(`${shown} === '0021.webp'`, "the last value");
  await tab.key("Tab"); // the button
  await tab.key("Tab");
  await tab.key("Home");
  await tab.until(`${shown} === '0018.webp'`, "the first moment");
  await tab.evaluate("document.querySelector('input.value').scrollIntoView({ block: 'center', behavior: 'instant' })");
  const box = await tab.evaluate("(() => { const b = document.querySelector('input.value').getBoundingClientRect(); return [b.left + 12, b.top + b.height / 2]; })()");
  await tab.press({ x: box[0], y: box[1] });
  await tab.release({ x: box[0], y: box[1] });
  await tab.until(`${shown} === '0000.webp'`, "the first value");
  assert.deepEqual(tab.errors, []);
});

test("other values are other pictures, and the first moment is the same in all", async () => {
  const media = (n) => readFileSync(join(folder, `g/media/dam_break_flip_ratio_${String(n).padStart(4, "0")}.webp`));
  assert.notDeepEqual(media(5), media(23), "PIC and FLIP at the end");
  assert.notDeepEqual(media(0), media(5), "the beginning and the end");
});

test("plays through the moments and pauses", async () => {
  const tab = await browser.open(page);
  await walk(tab);
  await tab.evaluate("document.querySelector('.scrubber').scrollIntoView({ behavior: 'instant' })");
  const k = "document.querySelector('input.time').valueAsNumber";
  const before = await tab.evaluate(k);
  assert.equal(await tab.evaluate("document.querySelector('.play').getAttribute('aria-label')"), "Play");
  await tab.click(".play");
  await tab.until(`${k} !== ${before}`, "the next moment");
  assert.equal(await tab.evaluate("document.querySelector('.play').getAttribute('aria-label')"), "Pause");
  await tab.click(".play");
  const at = await tab.evaluate(k);
  await sleep(700);
  assert.equal(await tab.evaluate(k), at);
});

test("videos play in view, unless less motion is wanted", async () => {
  const watch = async (reduced) => {
    const tab = await browser.open(page, { reduced });
    await tab.evaluate("document.querySelector('video').scrollIntoView({ block: 'center', behavior: 'instant' })");
    return tab;
  };
  const lively = await watch(false);
  await lively.until("document.querySelector('video').currentTime > 0.2", "the video to play");
  await lively.evaluate("window.scrollTo({ top: document.body.scrollHeight, behavior: 'instant' })");
  await lively.until("document.querySelector('video').paused", "it to pause out of view");
  await lively.evaluate("document.querySelector('video').scrollIntoView({ block: 'center', behavior: 'instant' })");
  await lively.until("!document.querySelector('video').paused", "it to go on");
  await lively.evaluate("document.querySelector('video').pause()");
  await lively.evaluate("window.scrollTo({ top: document.body.scrollHeight, behavior: 'instant' })");
  await sleep(300);
  await lively.evaluate("document.querySelector('video').scrollIntoView({ block: 'center', behavior: 'instant' })");
  await sleep(500);
  assert.equal(await lively.evaluate("document.querySelector('video').paused"), true, "who paused it finds it paused");
  const calm = await watch(true);
  await sleep(800);
  assert.equal(await calm.evaluate("document.querySelector('video').paused"), true);
  assert.equal(await calm.evaluate("document.querySelector('video').hasAttribute('controls')"), true);
});

test("subtitles work from the disk, and what changes can be jumped to", async () => {
  const tab = await browser.open(page, { reduced: true });
  await tab.click("[data-seek]");
  await tab.until("Math.abs(document.querySelector('video').currentTime - 0.4) < 0.06", "the video to be where the key is");
  await tab.evaluate("document.querySelector('video').textTracks[0].mode = 'showing'");
  await tab.until("document.querySelector('video').textTracks[0].activeCues?.length === 1", "the subtitle");
  assert.equal(await tab.evaluate("document.querySelector('video').textTracks[0].activeCues[0].text"), "FLIP slides to PIC");
  assert.deepEqual(tab.errors, []);
});

test("a command is copied", async () => {
  const tab = await browser.open(page);
  await tab.evaluate("navigator.clipboard && (navigator.clipboard.writeText = async (text) => { window.copied = text; })");
  await tab.click(".copy");
  await tab.until("document.querySelector('.copy').textContent.trim() !== 'Copy'", "an answer");
  const copied = await tab.evaluate("window.copied ?? String(getSelection())");
  assert.match(copied, /^flipbook render sliding\.toml -o sliding\.mp4 --ledger sliding\.csv/);
});

test("without scripts the pictures, videos and numbers are there", async () => {
  const tab = await browser.open("about:blank");
  await tab.command("Emulation.setScriptExecutionDisabled", { value: true });
  await tab.command("Page.navigate", { url: page });
  await sleep(800);
  const { root } = await tab.command("DOM.getDocument", { depth: 0 });
  const count = async (selector) => (await tab.command("DOM.querySelectorAll", { nodeId: root.nodeId, selector })).nodeIds.length;
  assert.equal(await count("video[controls]"), 1);
  assert.equal(await count(".scrubber img"), 1);
  assert.equal(await count(".dials[hidden]"), 1, "sliders that do nothing are not shown");
  assert.equal(await count(".copy[hidden]"), 3);
});

test("one file is the whole page", async () => {
  const tab = await browser.open(pathToFileURL(sent).href, { reduced: true });
  await walk(tab);
  for (const address of tab.requests) assert.match(address, /^data:|sent\.html$/);
  await tab.click("[data-seek]");
  await tab.until("Math.abs(document.querySelector('video').currentTime - 0.4) < 0.06", "the video inside the page");
  const first = await tab.evaluate("document.querySelector('.scrubber .screen img').src");
  await tab.evaluate("document.querySelector('input.value').focus()");
  await tab.key("ArrowRight");
  await tab.until(`document.querySelector('.scrubber .screen img').src !== ${JSON.stringify(first)}`, "another picture");
  assert.deepEqual(tab.errors, []);
});
