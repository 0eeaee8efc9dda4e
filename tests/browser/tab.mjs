// SPDX-License-Identifier: MIT
// A tab of the browser, driven as a person would: pointer, fingers and keys at the level of the browser's input, and
// looks at what the page shows.
import { writeFileSync } from "node:fs";
import { setTimeout as sleep } from "node:timers/promises";

const keyCodes = {
  Space: [" ", 32],
  Enter: ["Enter", 13],
  Tab: ["Tab", 9],
  Escape: ["Escape", 27],
  End: ["End", 35],
  Home: ["Home", 36],
  ArrowLeft: ["ArrowLeft", 37],
  ArrowUp: ["ArrowUp", 38],
  ArrowRight: ["ArrowRight", 39],
  ArrowDown: ["ArrowDown", 40],
  Backspace: ["Backspace", 8],
};
const texts = { Space: " ", Enter: "\r" };

export class Tab {
  #send;
  #close;
  requests = []; // addresses that it asked for
  errors = []; // exceptions of the page, and what it wrote to the console as an error

  constructor(send, close) {
    this.#send = send;
    this.#close = close;
  }

  async prepare({ width, height, touch, reduced, dark }) {
    await Promise.all([
      this.#send("Page.enable"),
      this.#send("Runtime.enable"),
      this.#send("Log.enable"),
      this.#send("Network.enable"),
    ]);
    await this.resize(width, height, touch);
    if (touch) await this.#send("Emulation.setTouchEmulationEnabled", { enabled: true, maxTouchPoints: 5 });
    const features = [];
    if (reduced) features.push({ name: "prefers-reduced-motion", value: "reduce" });
    if (dark) features.push({ name: "prefers-color-scheme", value: "dark" });
    if (features.length) await this.#send("Emulation.setEmulatedMedia", { features });
  }

  happened(method, params) {
    if (method === "Network.requestWillBeSent") this.requests.push(params.request.url);
    if (method === "Runtime.exceptionThrown")
      this.errors.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === "Log.entryAdded" && params.entry.level === "error")
      this.errors.push(`${params.entry.text} ${params.entry.url ?? ""}`);
  }

  async go(url) {
    await this.#send("Page.navigate", { url });
    await this.until("document.readyState === 'complete'", `${url} to load`);
  }

  resize(width, height, mobile = false) {
    return this.#send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile });
  }

  command(method, params) {
    return this.#send(method, params);
  }

  close() {
    return this.#close();
  }

  // Looking ---------------------------------------------------------------------------------------------------------

  async evaluate(expression) {
    const { result, exceptionDetails } = await this.#send("Runtime.evaluate", {
      expression,
      awaitPromise: true,
      returnByValue: true,
    });
    if (exceptionDetails) throw new Error(`${expression}: ${exceptionDetails.exception?.description ?? exceptionDetails.text}`);
    return result.value;
  }

  /// Waits until the expression is true and returns its value; `what` is for the message.
  async until(expression, what = expression, seconds = 20) {
    const end = Date.now() + 1000 * seconds;
    for (;;) {
      const value = await this.evaluate(expression).catch(() => undefined); // between two pages there is nothing to ask
      if (value) return value;
      if (Date.now() > end) throw new Error(`Waited ${seconds} s for ${what}`);
      await sleep(40);
    }
  }

  text(id) {
    return this.evaluate(`document.getElementById(${JSON.stringify(id)}).textContent.trim()`);
  }

  /// The middle of what the selector finds, in the window.
  async middle(selector) {
    const box = await this
      .evaluate(`(() => { const e = document.querySelector(${JSON.stringify(selector)}); e.scrollIntoView({ block: "nearest", behavior: "instant" });
      const b = e.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; })()`);
    return { x: box[0], y: box[1] };
  }

  /// A place in the picture, by fractions of it, in the window.
  async inPicture(x, y) {
    const box = await this.evaluate(`(() => { const e = document.getElementById("picture"), b = e.getBoundingClientRect();
      const scale = Math.min(b.width / e.width, b.height / e.height);
      return [b.x + b.width / 2, b.y + b.height / 2, scale * e.width, scale * e.height]; })()`);
    return { x: box[0] + (x - 0.5) * box[2], y: box[1] + (y - 0.5) * box[3] };
  }

  async screenshot(file) {
    const { data } = await this.#send("Page.captureScreenshot", { format: "png" });
    writeFileSync(file, Buffer.from(data, "base64"));
  }

  /// The whole page, however long.
  async screenshotOfAll(file) {
    const { cssContentSize } = await this.#send("Page.getLayoutMetrics");
    const { width, height } = cssContentSize;
    const clip = { x: 0, y: 0, width, height, scale: 1 };
    const { data } = await this.#send("Page.captureScreenshot", { format: "png", clip, captureBeyondViewport: true });
    writeFileSync(file, Buffer.from(data, "base64"));
  }

  // Doing -----------------------------------------------------------------------------------------------------------

  mouse(type, { x, y }, more = {}) {
    return this.#send("Input.dispatchMouseEvent", { type, x, y, ...more });
  }

  async press(at, button = "left") {
    await this.mouse("mouseMoved", at);
    await this.mouse("mousePressed", at, { button, buttons: button === "left" ? 1 : 2, clickCount: 1 });
  }

  release(at, button = "left") {
    return this.mouse("mouseReleased", at, { button, clickCount: 1 });
  }

  async click(selector) {
    const at = await this.middle(selector);
    await this.press(at);
    await this.release(at);
  }

  /// From one place to another in `steps` moves with the button held, one at a time so that each is a message.
  async drag(from, to, steps = 12) {
    await this.press(from);
    for (let i = 1; i <= steps; ++i) {
      const along = (a, b) => a + ((b - a) * i) / steps;
      await this.mouse("mouseMoved", { x: along(from.x, to.x), y: along(from.y, to.y) }, { button: "left", buttons: 1 });
      await sleep(25);
    }
    await this.release(to);
  }

  async key(name, { shift = false } = {}) {
    const [key, windowsVirtualKeyCode] = keyCodes[name] ?? [name, name.toUpperCase().charCodeAt(0)];
    const text = texts[name] ?? (name.length === 1 ? name : undefined);
    const modifiers = shift ? 8 : 0;
    await this.#send("Input.dispatchKeyEvent", {
      type: text ? "keyDown" : "rawKeyDown",
      key,
      code: name,
      windowsVirtualKeyCode,
      text,
      modifiers,
    });
    await this.#send("Input.dispatchKeyEvent", { type: "keyUp", key, code: name, windowsVirtualKeyCode, modifiers });
  }

  type(text) {
    return this.#send("Input.insertText", { text });
  }

  /// `points`: [[x, y], ...]; an empty list lifts all fingers.
  touch(type, points) {
    return this.#send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  }

  async tap(selector) {
    const { x, y } = await this.middle(selector);
    await this.touch("touchStart", [[x, y]]);
    await this.touch("touchEnd", []);
  }
}
