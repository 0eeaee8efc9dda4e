// SPDX-License-Identifier: MIT
// The dialog that lists the studies and scenes of the program and opens one of them.

const readable = (name) => name.replaceAll("_", " ");

export class Chooser {
  #dialog = document.getElementById("chooser");
  #filter = document.getElementById("chooser-filter");
  #list = document.getElementById("choices");
  #warning = document.getElementById("chooser-warning");
  #open;

  /// `open(kind, name)`: kind is "study" or "scene".
  constructor(open) {
    this.#open = open;
    this.#filter.addEventListener("input", () => this.#search());
    this.#dialog.addEventListener("keydown", (e) => this.#key(e));
  }

  fill({ studies, scenes }) {
    this.#list.replaceChildren();
    this.#section("Studies", "study", studies);
    this.#section("Scenes", "scene", scenes);
    const none = this.#list.appendChild(document.createElement("p"));
    none.className = "hint none";
    none.textContent = "Nothing of that name.";
    none.hidden = true;
  }

  show(state) {
    for (const choice of this.#choices())
      choice.setAttribute("aria-current", String(choice.dataset.kind === state?.kind && choice.dataset.name === state.name));
    const edits = state?.edits ?? 0;
    this.#warning.hidden = edits === 0;
    this.#warning.textContent = `${edits} ${edits === 1 ? "edit is" : "edits are"} not kept when another one opens. Save them as a study first if you need them.`;
    this.#filter.value = "";
    this.#search();
    this.#dialog.showModal();
    this.#list.querySelector("[aria-current=true]")?.scrollIntoView({ block: "center" });
    if (!matchMedia("(pointer: coarse)").matches) this.#filter.focus(); // on a phone a keyboard would cover the list
  }

  #section(heading, kind, entries) {
    const section = this.#list.appendChild(document.createElement("section"));
    section.appendChild(document.createElement("h3")).textContent = heading;
    for (const { name, title } of entries) {
      const choice = section.appendChild(document.createElement("button"));
      choice.type = "button";
      choice.className = "choice";
      Object.assign(choice.dataset, { kind, name, words: `${readable(name)} ${name} ${title}`.toLowerCase() });
      choice.appendChild(document.createElement("b")).textContent = readable(name);
      choice.append(" ");
      choice.appendChild(document.createElement("span")).textContent = title;
      choice.addEventListener("click", () => this.#chosen(choice));
    }
  }

  #chosen(choice) {
    this.#dialog.close();
    this.#open(choice.dataset.kind, choice.dataset.name);
  }

  #choices() {
    return [...this.#list.querySelectorAll(".choice")];
  }

  #search() {
    const words = this.#filter.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const choice of this.#choices()) choice.hidden = !words.every((w) => choice.dataset.words.includes(w));
    for (const section of this.#list.querySelectorAll("section"))
      section.hidden = !section.querySelector(".choice:not([hidden])");
    const none = this.#list.querySelector(".none");
    if (none) none.hidden = this.#choices().some((c) => !c.hidden);
  }

  /// Arrows walk through what was found, Enter in the field opens the first of it.
  #key(e) {
    const found = this.#choices().filter((c) => !c.hidden);
    const at = found.indexOf(document.activeElement);
    if (e.key === "Enter" && document.activeElement === this.#filter && found.length) {
      e.preventDefault();
      this.#chosen(found[0]);
    }
    if (e.key !== "ArrowDown" && e.key !== "ArrowUp") return;
    e.preventDefault();
    const next = at + (e.key === "ArrowDown" ? 1 : -1);
    (next < 0 ? this.#filter : found[Math.min(next, found.length - 1)])?.focus();
  }
}
