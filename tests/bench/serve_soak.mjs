// SPDX-License-Identifier: MIT
// Ten minutes of pages that come and go, well and badly, and what that leaves behind in the program: memory, open files,
// threads. Exit 1 if memory grew by more than 16 MiB after the first fifth, or if files or threads did.
//   FLIPBOOK=build/release/flipbook node tests/bench/serve_soak.mjs [--minutes 10] [--csv soak.csv]
import { appendFileSync, readdirSync, writeFileSync } from "node:fs";
import { setTimeout as sleep } from "node:timers/promises";

import { Browser } from "../browser/chromium.mjs";
import { connected, small } from "../browser/live.mjs";
import { Program } from "../browser/program.mjs";

const option = (name, otherwise) => {
  const at = process.argv.indexOf(`--${name}`);
  return at < 0 ? otherwise : process.argv[at + 1];
};
const minutes = Number(option("minutes", 10));
const csv = option("csv", "");
const largestGrowth = 16; // MiB

const program = await Program.start(small);
const browser = new Browser();
const token = new URL(program.url).hash.slice(1);
const watcher = await browser.open(program.url);
await connected(watcher);

/// One connection from the page's own origin; `act` is what it does once it is open.
const socket = (act, query = token) =>
  watcher.evaluate(`new Promise((done) => {
  const ws = new WebSocket('ws://' + location.host + '/ws?${query}');
  ws.onopen = () => { ${act}; };
  ws.onclose = ws.onerror = () => done();
  setTimeout(() => (ws.close(), done()), 2000);
})`);

/// What people and others do, in turn.
const visits = [
  async () => {
    // a person who looks and moves the pointer
    const tab = await browser.open(program.url, { width: 900, height: 600 });
    await connected(tab);
    const { x, y } = await tab.middle("#picture");
    for (let i = 0; i < 20; ++i) await tab.mouse("mouseMoved", { x: x + 5 * i, y });
    await tab.close();
  },
  () => Promise.all(Array.from({ length: 6 }, () => socket("ws.close()"))), // who leaves at once
  () => socket("setTimeout(() => ws.close(), 1500)"), // who never acknowledges
  () => socket("", "token=wrong"),
  () => socket("ws.send('{')"),
  () => socket("ws.send('x'.repeat(100000))"),
  () => socket("ws.send(new Uint8Array(64))"),
  () => socket('for (let i = 0; i < 2000; ++i) ws.send(\'{"type":"ack","picture":\' + i + \'}\')'),
  () => watcher.click("#reset"),
  async () => {
    // who takes over and gives back
    const tab = await browser.open(program.url);
    await connected(tab);
    await tab.click("#drive");
    await tab.until("document.getElementById('role').textContent.startsWith('You drive')");
    await tab.click("#step");
    await tab.close();
  },
];

const count = (what) => readdirSync(`/proc/${program.pid}/${what}`).length;
const samples = [];
function sample(start) {
  samples.push({
    seconds: Math.round((Date.now() - start) / 1000),
    memory: program.memory,
    files: count("fd"),
    threads: count("task"),
  });
  const line = Object.values(samples.at(-1))
    .map((x) => Math.round(10 * x) / 10)
    .join(",");
  if (csv) appendFileSync(csv, `${line}\n`);
}

if (csv) writeFileSync(csv, "seconds,memory_MiB,files,threads\n");
const start = Date.now();
let visitsMade = 0;
await watcher.until("!document.getElementById('start').disabled");
if ((await watcher.text("start")) === "Start") await watcher.click("#start");
for (let next = 0; Date.now() - start < 60000 * minutes; ++visitsMade) {
  await visits[visitsMade % visits.length]();
  await sleep(100);
  if (Date.now() >= start + next) {
    sample(start);
    next = Date.now() - start + 5000;
  }
}
await sleep(2000); // what was closed last goes
sample(start);

const settled = samples.slice(Math.floor(samples.length / 5));
const mean = (list, key) => list.reduce((sum, s) => sum + s[key], 0) / list.length;
const third = Math.max(1, Math.floor(settled.length / 3));
const grown = (key) => mean(settled.slice(-third), key) - mean(settled.slice(0, third), key);
console.log(`${visitsMade} visits in ${minutes} minutes
memory  ${samples[0].memory.toFixed(1)} MiB at first, ${settled[0].memory.toFixed(1)} settled, ${samples.at(-1).memory.toFixed(1)} at the end; growth ${grown("memory").toFixed(1)} MiB
files   ${settled[0].files} settled, ${samples.at(-1).files} at the end
threads ${settled[0].threads} settled, ${samples.at(-1).threads} at the end`);
await browser.close();
const code = await program.stop();
if (code !== 0) console.log(`flipbook serve ended with ${code}`);
const tooMuch =
  grown("memory") > largestGrowth ||
  samples.at(-1).files > settled[0].files + 8 ||
  samples.at(-1).threads > settled[0].threads + 2;
process.exit(code !== 0 || tooMuch ? 1 : 0);
