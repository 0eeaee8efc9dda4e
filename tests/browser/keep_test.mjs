// SPDX-License-Identifier: MIT
// What the page keeps: recordings, snapshots and studies are whole files in the output folder, and a saved study rendered
// offline gives the recorded pictures again.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";

import { live, message, openParameters, pause } from "./live.mjs";
import { flipbook } from "./program.mjs";

const session = live();
const newest = (ending) =>
  readdirSync(session.program.folder)
    .filter((f) => f.endsWith(ending))
    .sort()
    .at(-1);
const inFolder = (name) => join(session.program.folder, name);

async function record(tab, kind, frames) {
  await tab.evaluate(`document.getElementById('format').value = '${kind}'`);
  await tab.click("#record");
  await tab.until("document.getElementById('record').getAttribute('aria-pressed') === 'true'", "the recording to start");
  if ((await tab.text("start")) === "Start") await tab.click("#start");
  await tab.until(
    `Number(document.getElementById('record').textContent.replace(/\\D/g, '')) >= ${frames}`,
    `${frames} recorded frames`,
  );
  await tab.click("#record");
  return message(tab, "/Saved|saved/");
}

test("records a video that holds what it says", async () => {
  const tab = await session.open();
  await pause(tab);
  await record(tab, "video", 12);
  await tab.until("document.getElementById('record').textContent.trim() === 'Record'", "the recording to end");
  const video = inFolder(newest(".mp4"));
  const probe = [
    "-v",
    "error",
    "-count_frames",
    "-select_streams",
    "v",
    "-show_entries",
    "stream=nb_read_frames",
    "-of",
    "csv=p=0",
    video,
  ];
  assert.ok(Number(execFileSync("ffprobe", probe).toString().trim()) >= 12);
  assert.deepEqual(tab.errors, []);
});

test("takes a snapshot that knows its study", async () => {
  const tab = await session.open();
  await tab.click("#snapshot");
  await message(tab, "/\\.png/");
  const picture = inFolder(newest(".png"));
  assert.equal(readFileSync(picture).subarray(1, 4).toString(), "PNG");
  assert.match(execFileSync(flipbook, ["info", picture, "--study"]).toString(), /dam_break/);
});

test("a saved study renders the recorded pictures again", async () => {
  const tab = await session.open();
  await pause(tab);
  await tab.click("#reset");
  await tab.until("document.getElementById('frame').textContent === 'frame 0'", "frame 0");
  await openParameters(tab);
  await tab.evaluate("document.getElementById('format').value = 'png'");
  await tab.click("#record");
  await tab.until("document.getElementById('record').getAttribute('aria-pressed') === 'true'", "the recording to start");
  await tab.click("#start");
  await tab.until("Number(document.getElementById('frame').textContent.slice(6)) >= 6", "six frames");
  await tab.click("#tools label:has([value=push])");
  const { x, y } = await tab.middle("#picture");
  await tab.drag({ x: x - 250, y: y + 60 }, { x: x - 200, y: y + 20 });
  await tab.until("Number(document.getElementById('frame').textContent.slice(6)) >= 20", "twenty frames");
  await pause(tab);
  await tab.click("#record");
  await tab.until("document.getElementById('record').textContent.trim() === 'Record'", "the recording to end");
  await tab.click("#save");
  await message(tab, "/\\.toml/");
  const study = inFolder(newest(".toml"));
  const recorded = readdirSync(session.program.folder, { withFileTypes: true })
    .filter((d) => d.isDirectory())
    .at(-1).name;
  const frames = readdirSync(inFolder(recorded))
    .filter((f) => f.endsWith(".png"))
    .sort();
  assert.ok(frames.length >= 15, `${frames.length} recorded frames`);

  const again = mkdtempSync(join(tmpdir(), "flipbook-again-"));
  execFileSync(flipbook, ["render", study, "-o", `${again}/`], { stdio: "pipe" });
  for (const frame of frames)
    assert.ok(pixels(inFolder(join(recorded, frame))).equals(pixels(join(again, frame))), `${frame} differs`);
  rmSync(again, { recursive: true });
  assert.deepEqual(tab.errors, []);
});

const pixels = (file) =>
  execFileSync("ffmpeg", ["-v", "error", "-i", file, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"], { maxBuffer: 1 << 26 });
