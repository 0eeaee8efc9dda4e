// SPDX-License-Identifier: MIT
// Takes the picture of the page for the project's README: the default study, a while after the start, pushed by the pointer.
//   node tests/browser/picture.mjs live.png
import { Browser } from "./chromium.mjs";
import { connected } from "./live.mjs";
import { Program } from "./program.mjs";

const file = process.argv[2] ?? "live.png";
const program = await Program.start(["dam_break"]);
const browser = new Browser();
const tab = await browser.open(program.url, { width: 1280, height: 800 });
await connected(tab);
await tab.until("!document.getElementById('start').disabled", "the controls");
await tab.click("#start");
await tab.until("Number(document.getElementById('frame').textContent.slice(6)) >= 22", "the wave to run", 300);
await tab.click("#tools label:has([value=push])");
const [from, to] = [await tab.inPicture(0.29, 0.91), await tab.inPicture(0.34, 0.77)];
await tab.press(from);
for (let i = 0; i <= 60; ++i) {
  const at = { x: from.x + ((to.x - from.x) * i) / 60, y: from.y + ((to.y - from.y) * i) / 60 };
  await tab.mouse("mouseMoved", at, { button: "left", buttons: 1 });
  await new Promise((next) => setTimeout(next, 60));
}
await tab.screenshot(file);
await tab.release(to);
await browser.close();
await program.stop();
