// SPDX-License-Identifier: MIT
// The line for what the program has to say: news goes by itself, errors stay until they are dismissed.

const seconds = { info: 8, warning: 20, error: Infinity };
const weight = { info: 0, warning: 1, error: 2 };

export class Messages {
  #line;
  #dismiss;
  #all = []; // {level, text, until}, oldest first

  constructor(line, dismiss) {
    this.#line = line;
    this.#dismiss = dismiss;
    dismiss.addEventListener("click", () => this.dismiss());
    setInterval(() => this.#expire(), 500);
  }

  say(level, text) {
    this.#all = this.#all.filter((m) => m.text !== text).slice(-19);
    this.#all.push({ level, text, until: performance.now() + 1000 * (seconds[level] ?? seconds.info) });
    this.#show();
  }

  /// Takes the shown message away; an older one that still matters comes back.
  dismiss() {
    const shown = this.#shown();
    this.#all = this.#all.filter((m) => m !== shown);
    this.#show();
  }

  /// News of a connection that is no more.
  forget() {
    this.#all = this.#all.filter((m) => m.level === "error");
    this.#show();
  }

  /// The gravest, of these the newest.
  #shown() {
    return this.#all.reduce((best, m) => (best && weight[best.level] > weight[m.level] ? best : m), null);
  }

  #expire() {
    const now = performance.now();
    if (!this.#all.some((m) => m.until <= now)) return;
    this.#all = this.#all.filter((m) => m.until > now);
    this.#show();
  }

  #show() {
    const shown = this.#shown();
    const text = shown?.text ?? "";
    this.#line.dataset.level = shown?.level ?? "info";
    this.#line.setAttribute("aria-live", shown?.level === "error" ? "assertive" : "polite");
    if (this.#line.textContent !== text) this.#line.textContent = text; // a live region reads each change aloud
    this.#dismiss.hidden = shown?.level !== "error";
    this.#line.dispatchEvent(new CustomEvent("shown", { detail: shown?.level ?? null }));
  }
}
