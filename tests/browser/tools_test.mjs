// SPDX-License-Identifier: MIT
// The pointer's tools in the picture: they add and remove particles, push, drag a solid, and every one is an edit of the run.
import assert from "node:assert/strict";
import { test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";

import { fields, frameNumber, live, openParameters, openScene, pause, particles, restart, scene } from "./live.mjs";

const session = live([scene, "--cells", "32", "--size", "960x540"]);

/// Of the run so far, as the chooser warns.
async function edits(tab) {
  await tab.click("#choose");
  await tab.until("document.getElementById('chooser').open");
  const text = await tab.evaluate(
    "document.getElementById('chooser-warning').hidden ? '0' : document.getElementById('chooser-warning').textContent",
  );
  await tab.key("Escape");
  return Number.parseInt(text, 10);
}

/// Takes a tool, presses it at `from` and moves to `to` while the run goes some frames further: a slow machine gets its time.
async function use(tab, tool, from, to = from, frames = 4) {
  await tab.click(`#tools label:has([value=${tool}])`);
  const start = await frameNumber(tab);
  await tab.press(from);
  for (let i = 1; i <= 200 && ((await frameNumber(tab)) < start + frames || i <= 12); ++i) {
    const along = (a, b) => a + ((b - a) * Math.min(i, 12)) / 12;
    await tab.mouse("mouseMoved", { x: along(from.x, to.x), y: along(from.y, to.y) }, { button: "left", buttons: 1 });
    await sleep(25);
  }
  await tab.release(to);
}
// In the pane: above the liquid of the first frames, and in it.
const air = [0.35, 0.35],
  water = [0.08, 0.75];

test("adds particles", async () => {
  const tab = await session.open();
  await restart(tab);
  const before = await particles(tab);
  await use(tab, "add", await tab.inPicture(...air));
  await pause(tab);
  assert.ok((await particles(tab)) > before, `more than ${before}`);
  assert.ok((await edits(tab)) > 0);
  assert.deepEqual(tab.errors, []);
});

test("removes particles", async () => {
  const tab = await session.open();
  await restart(tab);
  const before = await particles(tab);
  await use(tab, "remove", await tab.inPicture(...water));
  await pause(tab);
  assert.ok((await particles(tab)) < before, `fewer than ${before}`);
  assert.ok((await edits(tab)) > 0);
});

test("a larger tool takes more", async () => {
  const tab = await session.open();
  const removed = async (radius) => {
    await restart(tab);
    const before = await particles(tab);
    await tab.click("#tools label:has([value=remove])");
    await tab.evaluate(
      `(() => { const r = document.getElementById('radius'); r.value = ${radius}; r.dispatchEvent(new Event('input')); })()`,
    );
    await use(tab, "remove", await tab.inPicture(...water));
    await pause(tab);
    return before - (await particles(tab));
  };
  const few = await removed(0.04),
    many = await removed(0.16);
  assert.ok(many > few && few > 0, `${few} and ${many}`);
});

test("pushes the fluid, and a reset forgets it", async () => {
  const tab = await session.open();
  await restart(tab);
  await use(tab, "push", await tab.inPicture(...water), await tab.inPicture(0.15, 0.6));
  assert.ok((await edits(tab)) > 0);
  await pause(tab);
  await tab.click("#reset");
  await tab.until("document.getElementById('frame').textContent === 'frame 0'", "frame 0");
  assert.deepEqual(tab.errors, []);
});

test("keys move and zoom the view of a plane", async () => {
  const tab = await session.open();
  await pause(tab);
  await openParameters(tab);
  const value = async (label) => (await fields(tab)).find((f) => f.label === label).value;
  const [zoom, target] = [await value("zoom"), await value("target")];
  await tab.evaluate("document.getElementById('picture').focus()");
  await tab.key("+");
  await tab.key("ArrowRight");
  for (let tries = 0; tries < 50 && (await value("target")) === target; ++tries) await sleep(100);
  assert.ok(Number(await value("zoom")) > Number(zoom));
  assert.notEqual(await value("target"), target);
  assert.deepEqual(tab.errors, []);
});

test("drags a solid, where there is one", async () => {
  const tab = await session.open();
  await pause(tab);
  assert.ok(await tab.evaluate("document.querySelector('[name=tool][value=solid]').disabled"), "this tank is empty");
  await openScene(tab, "dam_break_pillar");
  await tab.until("!document.querySelector('[name=tool][value=solid]').disabled", "the tool to be of use");
  await restart(tab);
  await sleep(500); // a picture of the new scene
  const pillar = await solidAt(tab);
  await use(tab, "solid", pillar, { x: pillar.x + 60, y: pillar.y - 40 });
  await pause(tab);
  assert.ok((await edits(tab)) > 0, "the pillar was moved");
  assert.deepEqual(tab.errors, []);
});

/// The middle of what has the colour of solids in the left half of the picture, but for the thin walls.
const solidAt = (tab) =>
  tab.evaluate(`(() => {
  const picture = document.getElementById('picture'), { width, height } = picture;
  const pen = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d');
  pen.drawImage(picture, 0, 0);
  const { data } = pen.getImageData(0, 0, width, height);
  const like = (x, y) => { const i = 4 * (y * width + x); return Math.abs(data[i] - 0x39) + Math.abs(data[i + 1] - 0x42) + Math.abs(data[i + 2] - 0x4d) < 16; };
  let n = 0, sx = 0, sy = 0;
  for (let y = 60; y < height - 40; ++y)
    for (let x = 40; x < 0.6 * width; ++x)
      if (like(x, y) && like(x - 8, y) && like(x + 8, y) && like(x, y - 8) && like(x, y + 8)) [n, sx, sy] = [n + 1, sx + x, sy + y];
  if (n < 50) throw new Error('no solid is seen: ' + n + ' pixels');
  const box = picture.getBoundingClientRect(), scale = Math.min(box.width / width, box.height / height);
  return { x: box.x + box.width / 2 + scale * (sx / n - width / 2), y: box.y + box.height / 2 + scale * (sy / n - height / 2) };
})()`);
