// SPDX-License-Identifier: MIT
// More than one page, a wrong link, and a program that ends and comes back.
import assert from "node:assert/strict";
import { test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";

import { connected, live, small } from "./live.mjs";
import { Program } from "./program.mjs";

const token = "a-link-that-stays-0123456789";
const session = live(small, { token });

test("one drives, the others watch until they take over", async () => {
  const first = await session.open();
  const second = await session.open();
  assert.equal(await second.text("role"), "You watch");
  await first.until("document.getElementById('role').textContent === 'You drive, 1 watches'", "the driver to see the viewer");
  for (const id of ["start", "step", "reset", "record", "snapshot", "save", "choose"])
    assert.ok(await second.evaluate(`document.getElementById('${id}').disabled`), `${id} is at rest for a viewer`);

  await second.click("#drive");
  await second.until("document.getElementById('role').textContent.startsWith('You drive')", "the viewer to drive");
  await first.until("document.getElementById('role').textContent === 'You watch'", "the driver to watch");
  assert.match(await first.text("message"), /Somebody else drives/);
  assert.ok(!(await second.evaluate("document.getElementById('start').disabled")));

  await second.click("#drive"); // hands over
  await first.until("document.getElementById('role').textContent.startsWith('You drive')", "the first to drive again");
  await first.close();
  await second.until("document.getElementById('role').textContent === 'You drive'", "the one who is left to drive");
  assert.deepEqual(second.errors, []);
});

test("a phone that takes over leaves the picture as large as others watch it", async () => {
  const wall = await session.open({ width: 1280, height: 800 });
  const width = () => wall.evaluate("document.getElementById('picture').width");
  await wall.until("document.getElementById('picture').width > 1000", "a picture for the wall");
  const before = await width();
  const phone = await session.open({ width: 390, height: 844, touch: true });
  await phone.tap("#drive");
  await phone.until("document.getElementById('role').textContent.startsWith('You drive')", "the phone to drive");
  await phone.tap("#step"); // a picture that was drawn after it
  await sleep(800);
  assert.equal(await width(), before);
});

test("a wrong link is explained", async () => {
  const wrong = session.program.url.replace(/token=.*/, "token=not-this-one-0123456789");
  const tab = await session.visit(wrong);
  await tab.until("document.getElementById('connection').dataset.state === 'refused'", "the refusal");
  assert.equal(await tab.text("absent-title"), "This link is not valid");
  assert.match(await tab.text("absent-text"), /address that flipbook serve printed last/);
});

test("connects again by itself after the program was restarted, and says so", async () => {
  const tab = await session.open();
  const { port, folder } = session.program;
  assert.equal(await session.program.stop({ keep: true }), 0, "Ctrl-C ends it well");
  await tab.until("document.getElementById('connection').dataset.state === 'waiting'", "the page to notice");
  assert.match(await tab.text("connection-text"), /The program has ended\. Trying again in \d+ s/);
  assert.equal(await tab.text("announced"), "The program has ended. This page tries again by itself.", "said aloud as well");
  assert.ok(await tab.evaluate("document.getElementById('start').disabled"), "nothing to drive meanwhile");
  assert.ok(await tab.evaluate("document.getElementById('stage').hasAttribute('data-stale')"), "an old picture looks old");

  session.program = await Program.start(small, { port, token, folder });
  await tab.until("document.getElementById('message').textContent === 'Connected again.'", "the page to come back", 30);
  await connected(tab);
  assert.equal(await tab.text("role"), "You drive");
  await tab.until("!document.getElementById('stage').hasAttribute('data-stale')", "a new picture");
});
