// SPDX-License-Identifier: MIT
// Frames a second and the latency from pointer to picture of `flipbook serve`, as a headless Chromium on the same machine
// sees them. Reports; asserts nothing.
//   FLIPBOOK=build/release/flipbook node tests/bench/serve.mjs [--seconds 15] [--window 1280x720] [--] [arguments of serve]
import { setTimeout as sleep } from "node:timers/promises";

import { Browser } from "../browser/chromium.mjs";
import { connected, scene } from "../browser/live.mjs";
import { Program } from "../browser/program.mjs";

const own = process.argv.slice(2);
const option = (name, otherwise) => {
  const at = own.indexOf(`--${name}`);
  return at < 0 ? otherwise : own.splice(at, 2)[1];
};
const seconds = Number(option("seconds", 15));
const [width, height] = option("window", "1280x720").split("x").map(Number);
const cases = own.filter((a) => a !== "--").length
  ? [own.filter((a) => a !== "--")]
  : [
      [scene, "--set", "transfer.scheme=apic", "--cells", "128"],
      [scene, "--set", "transfer.scheme=apic", "--dim", "3", "--cells", "34"],
    ];

const quantile = (sorted, q) => sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))] ?? NaN;

/// Moves the pointer over the picture, 40 times a second, until `end`.
async function move(tab, end) {
  const { x, y } = await tab.middle("#picture");
  for (let i = 0; Date.now() < end; ++i) {
    await tab.mouse("mouseMoved", { x: x + 0.3 * width * Math.sin(i / 20), y: y + 0.3 * height * Math.cos(i / 27) });
    await sleep(25);
  }
}

async function measure(what) {
  const program = await Program.start(what);
  const browser = new Browser();
  const tab = await browser.open(program.url, { width, height: height + 200 });
  await connected(tab);
  // The bar's height is the page's affair: the picture is to have the size asked for.
  const bar = await tab.evaluate("document.getElementById('bar').offsetHeight");
  await tab.resize(width, height + bar);
  await tab.until("!document.getElementById('start').disabled");
  if ((await tab.text("start")) === "Start") await tab.click("#start");
  await sleep(3000);
  await tab.evaluate(`(() => { const seen = (globalThis.measured = { drawn: [], seen: [] }), picture = document.getElementById('picture');
    picture.addEventListener('drawn', () => seen.drawn.push(performance.now()));
    picture.addEventListener('seen', (e) => seen.seen.push(e.detail)); })()`);
  await move(tab, Date.now() + 1000 * seconds);
  const { drawn, seen } = await tab.evaluate("measured");
  const size = await tab.evaluate(
    "[document.getElementById('picture').width, document.getElementById('picture').height].join('x')",
  );
  const gaps = drawn
    .slice(1)
    .map((t, i) => t - drawn[i])
    .sort((a, b) => a - b);
  seen.sort((a, b) => a - b);
  console.log(`flipbook serve ${what.join(" ")}
  picture ${size}, ${drawn.length} pictures in ${((drawn.at(-1) - drawn[0]) / 1000).toFixed(1)} s
  frames a second      ${((1000 * (drawn.length - 1)) / (drawn.at(-1) - drawn[0])).toFixed(1)}   (gap: median ${quantile(gaps, 0.5).toFixed(0)} ms, 95 % under ${quantile(gaps, 0.95).toFixed(0)} ms)
  pointer to picture   ${quantile(seen, 0.5).toFixed(0)} ms median, 95 % under ${quantile(seen, 0.95).toFixed(0)} ms, ${seen.length} movements
  frame of the run     ${await tab.text("frame")}, memory ${program.memory.toFixed(0)} MiB`);
  await browser.close();
  await program.stop();
}

for (const what of cases) await measure(what);
