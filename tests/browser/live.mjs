// SPDX-License-Identifier: MIT
// What the tests share: a program and a page of it, its form of parameters, and what its picture shows.
import { after, afterEach, before } from "node:test";

import { Browser } from "./chromium.mjs";
import { Program } from "./program.mjs";

/// One pane; the name alone is that of a study with four.
export const scene = new URL("../../assets/scenes/dam_break.toml", import.meta.url).pathname;

/// Few cells: the tests are about the page. Two panes that differ in one parameter.
export const small = ["dam_break", "--set", "grid.cells=[32,32]", "--size", "960x540"];

/// A program and a browser for the tests of a file. `live.open()` gives a page that is connected.
export function live(what = small, options = {}) {
  const session = {
    program: undefined,
    browser: undefined,
    tabs: [],
    /// A page at `url`, closed after the test whatever becomes of it: who is left open would drive on.
    async visit(url, window) {
      const tab = await this.browser.open(url, window);
      this.tabs.push(tab);
      return tab;
    },
    async open(window) {
      const tab = await this.visit(this.program.url, window);
      await connected(tab);
      return tab;
    },
  };
  before(async () => {
    session.program = await Program.start(what, options);
    session.browser = new Browser();
  });
  afterEach(async () => {
    await Promise.all(session.tabs.splice(0).map((tab) => tab.close().catch(() => {}))); // some were closed by their test
  });
  after(async () => {
    await session.browser?.close();
    await session.program?.stop();
  });
  return session;
}

export async function connected(tab) {
  await tab.until("document.getElementById('connection').dataset.state === 'open'", "the page to connect");
  await tab.until("!document.getElementById('stage').hasAttribute('data-empty')", "the first picture");
  await tab.until("document.getElementById('role').textContent !== ''", "a role");
}

export const frameNumber = async (tab) => Number((await tab.text("frame")).match(/\d+/)?.[0]);

export async function pause(tab) {
  await tab.until("!document.getElementById('start').disabled", "the controls");
  if ((await tab.text("start")) === "Pause") await tab.click("#start");
  await tab.until("document.getElementById('start').textContent.trim() === 'Start'", "the run to pause");
}

/// From the first frame on, running.
export async function restart(tab) {
  await pause(tab);
  await tab.click("#reset");
  await tab.until("document.getElementById('frame').textContent === 'frame 0'", "frame 0");
  await tab.click("#start");
  await tab.until("document.getElementById('start').textContent.trim() === 'Pause'", "the run to start");
}

export async function openScene(tab, name) {
  await tab.click("#choose");
  await tab.click(`.choice[data-kind=scene][data-name=${name}]`);
  await tab.until(`document.getElementById('run-name').textContent === '${name.replaceAll("_", " ")}'`, `${name} to open`);
  await tab.until("!document.getElementById('start').disabled", "its controls");
}

export const particles = async (tab) => Number((await tab.text("run-size")).replace(/\D/g, ""));

/// The message that the page shows, once it matches.
export const message = (tab, pattern) =>
  tab.until(`document.getElementById('message').textContent.match(${pattern})?.input`, `a message like ${pattern}`);

/// The values in the form of parameters: [{label, of, value}].
export const fields = (tab) =>
  tab.evaluate(`[...document.querySelectorAll('#parameters-form .row')].map((row) => {
  const [label, of] = [row.querySelector('label').firstChild.textContent.trim(), row.querySelector('.of')?.textContent ?? ''];
  const input = row.querySelector('input:not([type=range]), select');
  return { label, of, id: input.id, value: input.type === 'checkbox' ? input.checked : input.value };
})`);

export async function openParameters(tab) {
  if (await tab.evaluate("document.getElementById('parameters').hidden")) await tab.click("#parameters-toggle");
  await tab.until("document.querySelector('#parameters-form .row')", "the form of parameters");
}

/// Pixels of the picture, as {width, height, colours, hash}: enough to tell a picture from a blank one and from another.
export const look = (tab) =>
  tab.evaluate(`(() => {
  const picture = document.getElementById('picture');
  const copy = Object.assign(document.createElement('canvas'), { width: picture.width, height: picture.height });
  const pen = copy.getContext('2d');
  pen.drawImage(picture, 0, 0);
  const { data } = pen.getImageData(0, 0, copy.width, copy.height);
  const colours = new Set();
  let hash = 17;
  for (let i = 0; i < data.length; i += 4) {
    const colour = (data[i] >> 4) << 8 | (data[i + 1] >> 4) << 4 | data[i + 2] >> 4;
    colours.add(colour);
    hash = (Math.imul(hash, 31) + colour) | 0;
  }
  return { width: copy.width, height: copy.height, colours: colours.size, hash };
})()`);
