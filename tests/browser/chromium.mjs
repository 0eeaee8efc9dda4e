// SPDX-License-Identifier: MIT
// A headless Chromium, spoken to over a pipe in its own protocol: nothing to install besides the browser.
import { spawn } from "node:child_process";
import { accessSync, constants, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";

import { Tab } from "./tab.mjs";

const names = ["chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"];

/// The browser's program, or undefined. FLIPBOOK_BROWSER names one.
export function findBrowser() {
  if (process.env.FLIPBOOK_BROWSER) return process.env.FLIPBOOK_BROWSER;
  const folders = (process.env.PATH ?? "").split(delimiter);
  for (const path of names.flatMap((name) => folders.map((folder) => join(folder, name)))) {
    try {
      accessSync(path, constants.X_OK);
      return path;
    } catch {
      // not there
    }
  }
  return undefined;
}

const options = (profile) => [
  "--headless",
  "--remote-debugging-pipe",
  `--user-data-dir=${profile}`,
  "--no-first-run",
  "--disable-extensions",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--disable-gpu",
  "--mute-audio",
  "--hide-scrollbars=false",
  "--force-color-profile=srgb",
  // Chromium refuses its sandbox to root, which containers and CI are.
  ...(process.getuid() === 0 ? ["--no-sandbox"] : []),
  "about:blank",
];

export class Browser {
  #process;
  #profile = mkdtempSync(join(tmpdir(), "flipbook-browser-"));
  #next = 1;
  #answers = new Map(); // id -> {resolve, reject, method}
  #tabs = new Map(); // session -> Tab
  #rest = Buffer.alloc(0);
  ended;

  constructor(program = findBrowser()) {
    this.#process = spawn(program, options(this.#profile), { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    this.ended = new Promise((resolve) => this.#process.on("exit", resolve));
    process.on("exit", () => this.#process.kill("SIGKILL"));
    this.ended.then(() => this.#answers.forEach(({ reject, method }) => reject(new Error(`The browser ended during ${method}`))));
    this.#process.stdio[4].on("data", (data) => this.#hear(data));
    this.#process.stdio[3].on("error", () => {}); // ended: the answers that are waited for say so
  }

  /// One command of the protocol; `session` is a tab's.
  send(method, params = {}, session = undefined) {
    const id = this.#next++;
    return new Promise((resolve, reject) => {
      this.#answers.set(id, { resolve, reject, method });
      this.#process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId: session })}\0`);
    });
  }

  /// A new tab of its own context, as another person's browser would be, with its page open.
  async open(url, { width = 1280, height = 800, touch = false, reduced = false, dark = false } = {}) {
    const { browserContextId } = await this.send("Target.createBrowserContext");
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank", browserContextId });
    const { sessionId } = await this.send("Target.attachToTarget", { targetId, flatten: true });
    const tab = new Tab(
      (method, params) => this.send(method, params, sessionId),
      () => this.send("Target.closeTarget", { targetId }),
    );
    this.#tabs.set(sessionId, tab);
    await tab.prepare({ width, height, touch, reduced, dark });
    await tab.go(url);
    return tab;
  }

  async close() {
    await this.send("Browser.close").catch(() => {});
    await this.ended;
    rmSync(this.#profile, { recursive: true, force: true, maxRetries: 5 });
  }

  get pid() {
    return this.#process.pid;
  }

  #hear(data) {
    this.#rest = Buffer.concat([this.#rest, data]);
    for (let end; (end = this.#rest.indexOf(0)) >= 0; this.#rest = this.#rest.subarray(end + 1))
      this.#take(JSON.parse(this.#rest.subarray(0, end).toString()));
  }

  #take(message) {
    if (message.id === undefined) return this.#tabs.get(message.sessionId)?.happened(message.method, message.params);
    const { resolve, reject, method } = this.#answers.get(message.id);
    this.#answers.delete(message.id);
    if (message.error) reject(new Error(`${method}: ${message.error.message}`));
    else resolve(message.result);
  }
}
