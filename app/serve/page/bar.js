// SPDX-License-Identifier: MIT
// The bar below the picture: shows the program's state, and asks for what its controls say.
import { fill } from "./field.js";

const $ = (id) => document.getElementById(id);
const icon = (button, name) => button.querySelector("use").setAttribute("href", `#i-${name}`);
/// Only what changes is written: screen readers and the browser's layout both notice every write.
const write = (element, text) => {
  if (element.textContent !== text) element.textContent = text;
};
const drives = ["start", "step", "reset", "choose", "tools", "radius", "link", "record", "format", "snapshot", "save"];

export class Bar {
  #app;
  #state = null;
  #role = null;

  /// `app`: `do(action, more)`, `choose()`, `parameters()`.
  constructor(app) {
    this.#app = app;
    const on = (id, act) => $(id).addEventListener("click", act);
    on("start", () => this.start());
    on("step", () => app.do("step"));
    on("reset", () => app.do("reset"));
    on("record", () => this.record());
    on("snapshot", () => app.do("snapshot"));
    on("save", () => app.do("save_study"));
    on("link", () => this.link());
    on("choose", () => app.choose());
    on("parameters-toggle", () => app.parameters());
    on("drive", () => app.do("drive", { take: this.#role !== "driver" }));
    on("full", () => this.full());
    document.addEventListener("fullscreenchange", () => this.#fullChanged());
    $("full").hidden = !document.fullscreenEnabled;
    $("tools").addEventListener("change", () => this.#toolChanged());
    $("radius").addEventListener("input", () => this.#tellRadius());
    this.#tellRadius();
    this.rest();
  }

  /// What the pointer does in the picture.
  get tool() {
    return document.querySelector("[name=tool]:checked").value;
  }
  get radius() {
    return Number($("radius").value);
  }

  // What the controls and the shortcuts do ---------------------------------------------------------------------------

  start() {
    this.#app.do(this.#state?.running ? "pause" : "play");
  }
  record() {
    if (this.#state?.recording) this.#app.do("stop_record");
    else this.#app.do("record", { kind: $("format").value });
  }
  link() {
    if (this.#state && !$("link").hidden) this.#app.do("link", { on: !this.#state.linked });
  }
  full() {
    if (document.fullscreenElement) document.exitFullscreen();
    else document.documentElement.requestFullscreen?.().catch(() => {});
  }
  take(tool) {
    const choice = document.querySelector(`[name=tool][value=${tool}]`);
    if (choice.disabled || $("tools").disabled) return;
    choice.checked = true;
    this.#toolChanged();
  }
  wider(factor) {
    const radius = $("radius");
    radius.value = Math.max(this.radius + 0.01 * Math.sign(factor - 1), this.radius * factor);
    if (factor < 1) radius.value = Math.min(this.radius, radius.value);
    this.#tellRadius();
  }

  // What it shows ----------------------------------------------------------------------------------------------------

  showRole({ role, clients }) {
    this.#role = role;
    const others = Math.max(0, (clients ?? 1) - 1);
    const watching = others === 1 ? "1 watches" : `${others} watch`;
    write($("role"), role === "driver" ? (others ? `You drive, ${watching}` : "You drive") : "You watch");
    $("drive").hidden = role === "driver" && others === 0;
    write($("drive"), role === "driver" ? "Hand over" : "Drive");
    $("stage").toggleAttribute("data-watching", role !== "driver");
    this.#enable();
  }

  showState(state) {
    this.#state = state;
    write($("start").querySelector("span"), state.running ? "Pause" : "Start");
    icon($("start"), state.running ? "pause" : "start");
    write($("time"), `${state.time.toFixed(2)} s`);
    write($("frame"), state.busy ? "preparing" : `frame ${state.frame}`);
    $("stage").setAttribute("aria-busy", String(state.busy));
    write($("run-size"), `${state.particles.toLocaleString("en")} particles`);
    if (state.name !== undefined) this.#showName(state); // nothing is open before the first scene is made
    this.#showRecording(state.recording);
    $("link").hidden = (state.panes?.length ?? 1) < 2;
    $("link").setAttribute("aria-pressed", String(state.linked));
    $("link").title = state.linked ? "An edit in one pane goes to all (L)" : "Each pane has its own values (L)";
    const solid = document.querySelector("[name=tool][value=solid]");
    solid.disabled = state.solids === 0;
    solid.parentElement.title = solid.disabled ? "This scene has no solid to drag" : "Drag a solid (5)";
    if (solid.disabled && solid.checked) this.take("camera");
    $("picture").style.cursor = this.tool === "camera" && state.cursor !== "default" ? state.cursor : "";
    this.#enable();
  }

  #showName({ name, title }) {
    write($("run-name"), name.replaceAll("_", " "));
    const heading = `${title || name} - Flipbook`;
    if (document.title !== heading) document.title = heading;
  }

  #showRecording(recording) {
    const button = $("record");
    button.setAttribute("aria-pressed", String(recording !== null));
    icon(button, recording ? "stop" : "record");
    write(button.querySelector("span"), recording ? `Stop ${recording.frames}` : "Record");
    const name = recording ? `Stop recording, ${recording.frames} frames` : "Record";
    if (button.getAttribute("aria-label") !== name) button.setAttribute("aria-label", name);
    button.title = recording ? `Recording ${recording.name}: ${recording.frames} frames (R)` : "Record what is seen (R)";
  }

  showNumbers(rate, latency) {
    write($("rate"), String(rate));
    write($("latency"), Number.isNaN(latency) ? "–" : latency.toFixed(0));
  }

  /// Without a connection there is nothing to drive.
  rest() {
    this.#role = null;
    write($("role"), "");
    $("drive").hidden = true;
    this.#enable();
  }

  #enable() {
    const may = this.#role === "driver" && this.#state !== null;
    for (const id of drives) $(id).disabled = !may;
    $("format").disabled = !may || this.#state.recording !== null;
  }

  #toolChanged() {
    $("stage").dataset.tool = this.tool;
    $("reach").hidden = this.tool === "camera" || this.tool === "solid";
    $("picture").style.cursor = "";
  }

  #tellRadius() {
    fill($("radius"));
    $("radius").setAttribute("aria-valuetext", `${Math.round(100 * this.radius)} percent of the domain`);
  }

  #fullChanged() {
    const is = document.fullscreenElement !== null;
    $("full").setAttribute("aria-pressed", String(is));
  }
}
