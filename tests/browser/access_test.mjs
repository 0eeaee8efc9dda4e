// SPDX-License-Identifier: MIT
// For everyone: names for screen readers, the keyboard alone, fingers, small windows, contrast, less motion.
import assert from "node:assert/strict";
import { test } from "node:test";

import { contrasts, overlaps } from "./layout.mjs";
import { fields, frameNumber, live, openParameters, pause } from "./live.mjs";

const session = live();
const controls = new Set([
  "button",
  "checkbox",
  "combobox",
  "radio",
  "slider",
  "spinbutton",
  "textbox",
  "searchbox",
  "link",
  "DisclosureTriangle",
  "application",
  "dialog",
  "form",
  "group",
]);

/// Roles and names of what assistive technology sees, without a name.
async function nameless(tab, atLeast) {
  const { nodes } = await tab.command("Accessibility.getFullAXTree");
  const seen = nodes.filter(
    (n) => !n.ignored && controls.has(n.role?.value) && n.properties?.some((p) => p.name === "focusable" && p.value.value),
  );
  assert.ok(seen.length >= atLeast, `${seen.length} controls`);
  return seen.filter((n) => !n.name?.value.trim()).map((n) => n.role.value);
}

test("every control has a name, in the page and in each dialog", async () => {
  const tab = await session.open();
  assert.deepEqual(await nameless(tab, 15), []);
  await openParameters(tab);
  await tab.evaluate("document.querySelector('#parameters-form details')?.setAttribute('open', '')");
  assert.deepEqual(await nameless(tab, 20), []);
  for (const opener of ["#help", "#choose"]) {
    await tab.click(opener);
    await tab.until("document.querySelector('dialog[open]')", opener);
    assert.deepEqual(await nameless(tab, 2), []); // a dialog is all there is while it is open
    await tab.key("Escape");
    assert.equal(await tab.evaluate("'#' + document.activeElement.id"), opener, "the focus goes back where it was");
  }
  assert.equal(await tab.evaluate("document.getElementById('message').getAttribute('role')"), "status");
});

test("Tab reaches every control, and the focus is seen", async () => {
  const tab = await session.open();
  await pause(tab);
  await tab.evaluate("document.activeElement.blur()");
  // One of a group of radio buttons is reached; arrows do the rest.
  const wanted = await tab.evaluate(`[...document.querySelectorAll('canvas, button, select, input')]
    .filter((e) => e.checkVisibility() && !e.disabled && e.closest('dialog') === null && (e.type !== 'radio' || e.checked)).map((e) => e.id || e.value)`);
  const reached = [];
  for (let i = 0; i < wanted.length + 2; ++i) {
    await tab.key("Tab");
    const [name, seen] =
      await tab.evaluate(`(() => { const e = document.activeElement, shown = e.type === 'radio' ? e.parentElement : e;
      const style = getComputedStyle(shown); return [e.id || e.value, style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2]; })()`);
    if (name) assert.ok(seen, `${name} has the focus and does not show it`);
    reached.push(name);
  }
  for (const name of wanted) assert.ok(reached.includes(name), `Tab never came to ${name}`);
});

test("the keyboard alone runs a session", async () => {
  const tab = await session.open();
  await pause(tab);
  await tab.evaluate("document.activeElement.blur()");
  await tab.key("Home");
  await tab.until("document.getElementById('frame').textContent === 'frame 0'", "Home to reset");
  await tab.key("n");
  await tab.until("document.getElementById('frame').textContent === 'frame 1'", "N to step");
  await tab.key("Space");
  await tab.until("document.getElementById('start').textContent.trim() === 'Pause'", "Space to start");
  await tab.until("Number(document.getElementById('frame').textContent.slice(6)) > 3", "the run to go on");
  await tab.key("Space");
  await tab.until("document.getElementById('start').textContent.trim() === 'Start'", "Space to pause");
  await tab.key("3");
  assert.equal(await tab.evaluate("document.querySelector('[name=tool]:checked').value"), "add");
  assert.ok(!(await tab.evaluate("document.getElementById('reach').hidden")), "tools have a radius");
  await tab.key("?", { shift: true });
  assert.ok(await tab.evaluate("document.getElementById('helper').open"));
  await tab.key("Escape");

  await tab.key("e");
  await tab.until("document.querySelector('#parameters-form .row')", "E to open the form");
  const slider = await tab.evaluate(
    "(() => { const s = document.querySelector('#parameters-form input[type=range]'); s.focus(); return s.value; })()",
  );
  const box = await tab.evaluate("document.activeElement.closest('.row').querySelector('input').id");
  for (let i = 0; i < 3; ++i) await tab.key("ArrowLeft");
  await tab.evaluate("document.activeElement.blur()");
  await tab.until(`document.getElementById('${box}').value !== '${slider}'`, "arrows to move a slider");
  assert.ok((await fields(tab)).some((f) => f.id === box));
  assert.deepEqual(tab.errors, []);
});

test("shortcuts can be switched off", async () => {
  const tab = await session.open();
  await pause(tab);
  await tab.click("#help");
  await tab.click("#shortcuts");
  await tab.key("Escape");
  await tab.evaluate("document.activeElement.blur()");
  const frame = await frameNumber(tab);
  await tab.key("n");
  await tab.click("#snapshot"); // what is answered after the key
  await tab.until("document.getElementById('message').textContent.includes('.png')", "a snapshot");
  assert.equal(await frameNumber(tab), frame);
});

for (const [width, height, touch] of [
  [360, 740, true],
  [390, 844, true],
  [844, 390, true],
  [768, 1024, true],
  [1024, 700, false],
  [1280, 800, false],
  [1920, 1080, false],
])
  test(`fits ${width} x ${height}`, async () => {
    const tab = await session.open({ width, height, touch });
    await pause(tab);
    await tab.evaluate("document.querySelector('[name=tool][value=push]').click()"); // with its radius
    const wide = (await tab.evaluate("document.documentElement.scrollWidth")) - width;
    assert.ok(wide <= 0, `${wide} pixels wider than the window`);
    assert.deepEqual(await overlaps(tab), []);
    if (touch) {
      const narrow =
        await tab.evaluate(`[...document.querySelectorAll('.bar button:not(.link), .bar select')].filter((e) => e.checkVisibility())
        .filter((e) => Math.min(e.offsetWidth, e.offsetHeight) < 32).map((e) => e.id)`);
      assert.deepEqual(narrow, [], "too small for a finger");
    }
  });

test("a finger presses the controls and the picture", async () => {
  const tab = await session.open({ width: 390, height: 844, touch: true });
  await pause(tab);
  await tab.tap("#reset");
  await tab.until("document.getElementById('frame').textContent === 'frame 0'", "a tap to reset");
  const { x, y } = await tab.middle("#picture");
  await tab.touch("touchStart", [[x, y]]);
  await tab.touch("touchStart", [
    [x, y],
    [x + 60, y],
  ]);
  for (let i = 1; i < 8; ++i)
    await tab.touch("touchMove", [
      [x - 5 * i, y],
      [x + 60 + 5 * i, y],
    ]);
  await tab.touch("touchEnd", []);
  assert.equal(await tab.evaluate("scrollY"), 0, "two fingers on the picture do not scroll the page");
  assert.deepEqual(tab.errors, []);
});

test("text stands out from what is behind it", async () => {
  const tab = await session.open();
  await openParameters(tab);
  const all = await contrasts(tab);
  assert.ok(all.length > 30, `${all.length} texts`);
  for (const { text, ratio } of all) assert.ok(ratio >= 4.5, `“${text}”: ${ratio.toFixed(2)}`);
});

test("less motion means none", async () => {
  const duration = async (tab) =>
    Number.parseFloat(await tab.evaluate("getComputedStyle(document.getElementById('start')).transitionDuration"));
  assert.ok((await duration(await session.open())) > 0);
  assert.equal(await duration(await session.open({ reduced: true })), 0);
});
