// SPDX-License-Identifier: MIT
// A run in space: the mouse, the arrow keys and two fingers move its camera, and what they did is in the parameters.
import assert from "node:assert/strict";
import { test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";

import { fields, live, look, openParameters, pause, scene } from "./live.mjs";

const session = live([scene, "--dim", "3", "--cells", "16", "--size", "960x540"]);

/// azimuth, elevation and zoom as the form says them.
async function camera(tab) {
  await openParameters(tab);
  const all = await fields(tab);
  const value = (label) => Number(all.find((f) => f.label === label).value);
  return { azimuth: value("azimuth"), elevation: value("elevation"), zoom: value("zoom") };
}

/// Waits until the camera differs from `before` in what is named, as the form is told a few times a second.
async function moved(tab, before, what) {
  for (let tries = 0; tries < 50; ++tries, await sleep(100)) {
    const now = await camera(tab);
    if (now[what] !== before[what]) return now;
  }
  throw new Error(`The ${what} stayed at ${before[what]}`);
}

test("a drag turns the camera, the wheel zooms", async () => {
  const tab = await session.open({ width: 1600, height: 900 });
  await pause(tab);
  const before = await camera(tab);
  const seen = await look(tab);
  const at = await tab.inPicture(0.3, 0.5);
  await tab.drag(at, { x: at.x + 90, y: at.y + 30 });
  const turned = await moved(tab, before, "azimuth");
  assert.notEqual(turned.elevation, before.elevation);
  await tab.mouse("mouseWheel", at, { deltaX: 0, deltaY: -200 });
  assert.ok((await moved(tab, turned, "zoom")).zoom > turned.zoom, "towards it");
  await sleep(400);
  assert.notEqual((await look(tab)).hash, seen.hash);
  assert.deepEqual(tab.errors, []);
});

test("arrows, plus and minus do the same for a keyboard", async () => {
  const tab = await session.open({ width: 1600, height: 900 });
  await pause(tab);
  const before = await camera(tab);
  await tab.evaluate("document.getElementById('picture').focus()");
  for (let i = 0; i < 3; ++i) await tab.key("ArrowRight");
  const turned = await moved(tab, before, "azimuth");
  await sleep(500);
  assert.ok(Math.abs((await camera(tab)).azimuth - before.azimuth - 15) < 1e-6, "three times five degrees");
  await tab.key("-");
  assert.ok((await moved(tab, turned, "zoom")).zoom < turned.zoom, "away from it");
});

test("two fingers turn and pinch", async () => {
  const tab = await session.open({ width: 844, height: 390, touch: true });
  await pause(tab);
  const before = await camera(tab);
  const { x, y } = await tab.inPicture(0.25, 0.35); // in the pane, beside the panel
  await tab.touch("touchStart", [[x - 20, y]]);
  await tab.touch("touchStart", [
    [x - 20, y],
    [x + 20, y],
  ]);
  for (let i = 1; i <= 10; ++i) {
    await tab.touch("touchMove", [
      [x - 20 - 3 * i + 4 * i, y],
      [x + 20 + 3 * i + 4 * i, y],
    ]);
    await sleep(25);
  }
  await tab.touch("touchEnd", []);
  const after = await moved(tab, before, "zoom");
  assert.ok(after.zoom > before.zoom, "fingers apart: nearer");
  assert.notEqual((await moved(tab, before, "azimuth")).azimuth, before.azimuth);
  assert.deepEqual(tab.errors, []);
});
