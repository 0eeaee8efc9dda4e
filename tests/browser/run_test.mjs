// SPDX-License-Identifier: MIT
// A run in the page: it connects, draws, starts, pauses, steps, resets, opens another scene, and takes the pointer's tools.
import assert from "node:assert/strict";
import { test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";

import { frameNumber, live, look, pause } from "./live.mjs";

const session = live();

test("connects, drives and draws", async () => {
  const tab = await session.open();
  assert.equal(await tab.text("connection-text"), "Connected");
  assert.equal(await tab.text("role"), "You drive");
  assert.equal(await tab.text("run-name"), "dam break");
  const seen = await look(tab);
  assert.ok(seen.colours > 20, `a picture has more than ${seen.colours} colours`);
  assert.deepEqual(tab.errors, []);
});

test("keeps the key out of the address bar, and across a reload", async () => {
  const tab = await session.open();
  assert.equal(await tab.evaluate("location.pathname + location.search + location.hash"), "/");
  await tab.command("Page.reload");
  await sleep(300);
  await tab.until("document.getElementById('connection')?.dataset.state === 'open'", "the page to connect again");
});

test("starts, pauses, steps and resets", async () => {
  const tab = await session.open();
  await pause(tab);
  await tab.click("#reset");
  await tab.until("document.getElementById('frame').textContent === 'frame 0'", "frame 0");
  for (const frame of [1, 2, 3]) {
    await tab.click("#step");
    await tab.until(`document.getElementById('frame').textContent === 'frame ${frame}'`, `frame ${frame}`);
  }
  await tab.click("#start");
  await tab.until("Number(document.getElementById('frame').textContent.slice(6)) > 12", "the run to go on");
  assert.equal(await tab.text("start"), "Pause");
  await pause(tab);
  const frame = await frameNumber(tab);
  await sleep(400);
  assert.equal(await frameNumber(tab), frame, "a paused run stands still");
});

test("the picture shows what the run does", async () => {
  const tab = await session.open();
  await pause(tab);
  await tab.click("#reset");
  await tab.until("document.getElementById('frame').textContent === 'frame 0'", "frame 0");
  await sleep(500);
  const before = await look(tab);
  await tab.click("#start");
  await tab.until("Number(document.getElementById('frame').textContent.slice(6)) > 10", "ten frames");
  await pause(tab);
  await sleep(500);
  const after = await look(tab);
  assert.notEqual(after.hash, before.hash);
});

test("opens another scene by typing a part of its name", async () => {
  const tab = await session.open();
  await pause(tab);
  await tab.click("#choose");
  await tab.until("document.getElementById('chooser').open");
  await tab.type("double dam");
  await tab.key("Enter");
  await tab.until("document.getElementById('run-name').textContent === 'double dam'", "the scene to open");
  assert.match(await tab.text("run-size"), /^[\d,]+ particles$/);
  await tab.until("document.getElementById('frame').textContent === 'frame 0'", "its first frame");
  await tab.until("!document.getElementById('start').disabled", "its controls");
  await tab.click("#choose");
  await tab.type("dam_break");
  await tab.click(".choice[data-kind=study][data-name=dam_break]");
  await tab.until("document.getElementById('run-name').textContent === 'dam break'", "the study to open");
  assert.deepEqual(tab.errors, []);
});
