// SPDX-License-Identifier: MIT
// The keyboard: shortcuts, the camera while the picture has the focus, and every key to a text box inside the picture.

const preference = "flipbook-shortcuts";

// What a key does to the camera: which parameter, and how its value changes.
const turn = 5; // degrees
const turns = {
  ArrowLeft: ["view.azimuth", (x) => x - turn],
  ArrowRight: ["view.azimuth", (x) => x + turn],
  ArrowUp: ["view.elevation", (x) => Math.min(90, x + turn)],
  ArrowDown: ["view.elevation", (x) => Math.max(-90, x - turn)],
};
const step = 0.05; // of the domain
const pans = {
  ArrowLeft: ["view.target", ([x, y, z]) => [x - step, y, z]],
  ArrowRight: ["view.target", ([x, y, z]) => [x + step, y, z]],
  ArrowUp: ["view.target", ([x, y, z]) => [x, y + step, z]],
  ArrowDown: ["view.target", ([x, y, z]) => [x, y - step, z]],
};
const closer = ["view.zoom", (x) => Math.min(50, x * 1.1)];
const zooms = { "+": closer, "=": closer, "-": ["view.zoom", (x) => Math.max(0.1, x / 1.1)] };

const typed = new Set(["INPUT", "SELECT", "TEXTAREA"]);

/// What `event` is called in a table of shortcuts: "Space", "Home", "n", "?".
const nameOf = (e) => (e.key === " " ? "Space" : e.key.length === 1 ? e.key.toLowerCase() : e.key);

export class Keys {
  #shortcuts;
  #canvas;
  #app;
  #whole = new Set(); // keys that went to the picture and have not come up

  /// `shortcuts`: [{key, text, run}]. `app`: `state()` of the program, `send(message)`, `camera(path, change)`.
  constructor(canvas, shortcuts, app) {
    this.#canvas = canvas;
    this.#shortcuts = shortcuts;
    this.#app = app;
    addEventListener("keydown", (e) => this.#down(e));
    addEventListener("keyup", (e) => this.#up(e));
    canvas.addEventListener("blur", () => this.#releaseAll());
  }

  /// Fills the table of the help dialog, and its switch for people whose keyboard types by itself (speech input).
  explain(list, box) {
    for (const { key, shown = key, text } of this.#shortcuts.filter((s) => s.text)) {
      const row = list.appendChild(document.createElement("div"));
      const term = row.appendChild(document.createElement("dt"));
      for (const one of shown.split(" ")) term.appendChild(document.createElement("kbd")).textContent = one;
      row.appendChild(document.createElement("dd")).textContent = text;
    }
    box.checked = localStorage.getItem(preference) !== "off";
    box.addEventListener("change", () => localStorage.setItem(preference, box.checked ? "on" : "off"));
  }

  #down(e) {
    if (document.querySelector("dialog[open]")) return;
    const focused = document.activeElement;
    const inPicture = focused === this.#canvas;
    if (inPicture && this.#app.state()?.keyboard) return this.#forward(e);
    if (e.ctrlKey || e.metaKey || e.altKey || e.isComposing) return;
    if (inPicture && this.#camera(e)) return e.preventDefault();
    if (typed.has(focused.tagName) && !(focused.type === "radio" && e.key.length === 1 && e.key !== " ")) return;
    if (e.key === " " && (focused.tagName === "BUTTON" || focused.tagName === "SUMMARY")) return; // presses that
    if (!inPicture && localStorage.getItem(preference) === "off") return;
    const shortcut = this.#shortcuts.find((s) => s.key.toLowerCase() === nameOf(e).toLowerCase());
    if (!shortcut || (e.repeat && !shortcut.repeats)) return;
    e.preventDefault();
    shortcut.run();
  }

  #camera(e) {
    const dim = this.#app.state()?.dim;
    const move = zooms[e.key] ?? (dim === 3 ? turns : pans)[e.key];
    if (!move || dim === undefined) return false;
    this.#app.camera(...move);
    return true;
  }

  // To the picture --------------------------------------------------------------------------------------------------

  #forward(e) {
    if (e.key === "Tab") return; // the way out, always
    e.preventDefault();
    const letter = [...e.key].length === 1 && !e.ctrlKey && !e.metaKey;
    if (letter) return this.#app.send({ type: "text", text: e.key });
    this.#whole.add(e.key);
    this.#send(e, true);
  }

  #up(e) {
    if (this.#whole.delete(e.key)) this.#send(e, false);
  }

  #send(e, down) {
    this.#app.send({ type: "key", key: e.key, down, shift: e.shiftKey, ctrl: e.ctrlKey, alt: e.altKey });
  }

  #releaseAll() {
    for (const key of this.#whole) this.#app.send({ type: "key", key, down: false, shift: false, ctrl: false, alt: false });
    this.#whole.clear();
  }
}
