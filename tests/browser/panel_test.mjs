// SPDX-License-Identifier: MIT
// The panel inside the picture, moved by the pointer as in the program's own window, and the form that says the same.
import assert from "node:assert/strict";
import { test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";

import { fields, live, look, openParameters, pause } from "./live.mjs";

const session = live();
const orange = [0xe6, 0x9f, 0x00]; // of the second pane

/// The longest run of a colour in the right part of the picture, as points of the window: a slider's filled track.
const track = (tab, colour) =>
  tab.evaluate(`(() => {
  const picture = document.getElementById('picture'), { width, height } = picture;
  const pen = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d');
  pen.drawImage(picture, 0, 0);
  const { data } = pen.getImageData(0, 0, width, height);
  const like = (i) => Math.abs(data[i] - ${colour[0]}) + Math.abs(data[i + 1] - ${colour[1]}) + Math.abs(data[i + 2] - ${colour[2]}) < 90;
  let best = { length: 0 };
  for (let y = 0; y < height; ++y)
    for (let x = Math.floor(0.78 * width), from = x; x < width; ++x)
      if (!like(4 * (y * width + x))) from = x + 1;
      else if (x - from > best.length) best = { length: x - from, x: from, y };
  const box = picture.getBoundingClientRect(), scale = Math.min(box.width / width, box.height / height);
  const place = (x, y) => ({ x: box.x + box.width / 2 + scale * (x - width / 2), y: box.y + box.height / 2 + scale * (y - height / 2) });
  return { length: best.length, left: place(best.x, best.y), right: place(best.x + best.length, best.y) };
})()`);

const ratio = async (tab) => {
  const all = (await fields(tab)).filter((f) => f.label === "flip ratio" && f.of.startsWith("FLIP"));
  return Number(all[0].value);
};

test("a slider in the picture follows the pointer", async () => {
  const tab = await session.open({ width: 1600, height: 900 });
  await pause(tab);
  await tab.click("#reset");
  await openParameters(tab);
  await sleep(600); // a picture of the new size
  assert.ok(Math.abs((await ratio(tab)) - 0.97) < 1e-6, "the study's own value");
  const { left, right, length } = await track(tab, orange);
  assert.ok(length > 20, `a filled track of ${length} pixels`);
  const before = await look(tab);
  await tab.drag(right, { x: left.x + 0.3 * (right.x - left.x), y: right.y });
  const { id } = (await fields(tab)).find((f) => f.label === "flip ratio");
  // The form is told a few times a second.
  const close = `Math.abs(Number(document.getElementById('${id}').value) - 0.3) < 0.1`;
  await tab
    .until(close, "the form to say three tenths", 10)
    .catch(async () => assert.fail(`dragged to 0.3, says ${await ratio(tab)}`));
  await sleep(300);
  assert.notEqual((await look(tab)).hash, before.hash);
  assert.deepEqual(tab.errors, []);
});

test("a phone gets the panes without the panel, whose place the form takes", async () => {
  const tab = await session.open({ width: 390, height: 844, touch: true });
  await pause(tab);
  await sleep(600);
  const { length } = await track(tab, orange);
  assert.ok(length < 20, `a track of ${length} pixels`);
  await openParameters(tab);
  assert.ok((await fields(tab)).some((f) => f.label === "flip ratio"));
});

test("the scheme of a pane changes in mid-run", async () => {
  const tab = await session.open();
  await pause(tab);
  await tab.click("#reset");
  await tab.click("#start");
  await openParameters(tab);
  const schemes = (await fields(tab)).filter((f) => f.label === "scheme");
  assert.ok(schemes.some((f) => f.value === "pic"));
  const { id } = schemes.find((f) => f.value === "pic");
  await tab.until("Number(document.getElementById('frame').textContent.slice(6)) > 3", "the run to be under way");
  await tab.evaluate(
    `(() => { const list = document.getElementById('${id}'); list.value = 'apic'; list.dispatchEvent(new Event('change', { bubbles: true })); })()`,
  );
  await tab.until(
    "[...document.querySelectorAll('#parameters-form .row')].every((r) => r.querySelector('select')?.value !== 'pic')",
    "the scheme to change",
  );
  const frame = Number((await tab.text("frame")).slice(6));
  await tab.until(`Number(document.getElementById('frame').textContent.slice(6)) > ${frame + 3}`, "the run to go on");
  await pause(tab);
  assert.deepEqual(tab.errors, []);
});

test("a wrong value is not sent", async () => {
  const tab = await session.open();
  await pause(tab);
  await openParameters(tab);
  const all = await fields(tab);
  const ratioField = all.find((f) => f.label === "flip ratio"),
    gravity = all.find((f) => /^(0, )?-9\.81|^0, -9\.81/.test(f.value));
  for (const [{ id }, text] of [
    [ratioField, "7"],
    [gravity, "down"],
  ]) {
    await tab.evaluate(`document.getElementById('${id}').focus(); document.getElementById('${id}').select()`);
    await tab.type(text);
    await tab.key("Enter");
    assert.ok(await tab.evaluate(`document.getElementById('${id}').matches(':invalid')`), `${text} is marked`);
  }
  const fresh = await session.open(); // the values that the program has
  await openParameters(fresh);
  const now = await fields(fresh);
  for (const { label, of, value } of [ratioField, gravity])
    assert.equal(now.find((f) => f.label === label && f.of === of).value, value);
  assert.equal(await tab.text("connection-text"), "Connected");
  assert.deepEqual(tab.errors, []);
});

test("a linked edit goes to all panes", async () => {
  const tab = await session.open();
  await pause(tab);
  if ((await tab.evaluate("document.getElementById('link').getAttribute('aria-pressed')")) === "false") await tab.click("#link");
  await tab.until("document.getElementById('link').getAttribute('aria-pressed') === 'true'", "the panes to be linked");
  await tab.click("#link");
  await tab.until("document.getElementById('link').getAttribute('aria-pressed') === 'false'", "the panes to be separate");
  assert.deepEqual(tab.errors, []);
});
