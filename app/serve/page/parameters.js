// SPDX-License-Identifier: MIT
// The parameters as a plain form beside the picture: what a keyboard, a screen reader and a narrow screen use in place of
// the sliders in the picture. Made from what the program describes; no parameter is known here by name.
import { makeField } from "./field.js";

/// "flip ratio" for "transfer.flip_ratio".
const label = (path) =>
  path
    .slice(path.indexOf(".") + 1)
    .replaceAll("_", " ")
    .replaceAll(".", " ");
const group = (path) => (path.includes(".") ? path.slice(0, path.indexOf(".")) : "run");
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

/// One row for each parameter that all panes share, one for each pane where they differ; then the view's.
function rowsOf({ panes, view }) {
  const rows = [];
  const paths = [...new Set(panes.flatMap((pane) => pane.parameters.map((p) => p.path)))];
  for (const path of paths) {
    const here = panes.map((pane, i) => ({ pane: i + 1, title: pane.title, p: pane.parameters.find((p) => p.path === path) }));
    const having = here.filter(({ p }) => p?.applies);
    if (having.length === 0) continue;
    const shared = having.length === panes.length && having.every(({ p }) => same(p.value, having[0].p.value));
    if (shared) rows.push({ p: having[0].p });
    else rows.push(...having);
  }
  rows.push(...view.filter((p) => p.applies).map((p) => ({ p })));
  return rows;
}

export class Parameters {
  #form = document.getElementById("parameters-form");
  #set;
  #shape = ""; // of the form as it stands
  #fields = [];
  #may = false;
  #view = [];

  /// `set(path, value, pane)`; pane is undefined for all.
  constructor(set) {
    this.#set = set;
    this.#form.addEventListener("submit", (e) => e.preventDefault());
  }

  /// `dim`: 2 or 3.
  show(message, dim) {
    this.#view = message.view;
    const rows = rowsOf(message);
    const shape = JSON.stringify([dim, ...rows.map(({ p, pane }) => [p.path, pane, p.kind, p.min, p.max, p.options])]);
    if (shape !== this.#shape) this.#build(rows, dim);
    this.#shape = shape;
    rows.forEach(({ p, title }, i) => this.#fields[i].show(p.value, title));
    this.enable(this.#may);
  }

  enable(may) {
    this.#may = may;
    for (const set of this.#form.querySelectorAll("fieldset")) set.disabled = !may;
  }

  /// The present value of a view's parameter.
  view(path) {
    return this.#view.find((p) => p.path === path);
  }
  /// Ahead of the program's answer, so that keys held down add up.
  expect(path, value) {
    const p = this.view(path);
    if (p) p.value = value;
  }

  #build(rows, dim) {
    const open = this.#form.querySelector("details")?.open ?? false;
    const focused = document.activeElement?.id;
    this.#fields = rows.map(({ p, pane, title }, i) =>
      makeField(p, {
        id: `parameter-${i}`,
        label: label(p.path),
        of: title,
        dim,
        set: (value) => this.#set(p.path, value, pane),
      }),
    );
    this.#form.replaceChildren();
    this.#section(this.#form, rows, (p) => p.level === "teach");
    const more = document.createElement("details");
    more.open = open;
    more.appendChild(document.createElement("summary")).textContent = "More parameters";
    this.#section(more, rows, (p) => p.level !== "teach");
    if (more.children.length > 1) this.#form.append(more);
    if (focused) document.getElementById(focused)?.focus();
  }

  #section(parent, rows, wanted) {
    const groups = new Map();
    rows.forEach(({ p }, i) => {
      if (!wanted(p)) return;
      const name = group(p.path);
      if (!groups.has(name)) groups.set(name, []);
      groups.get(name).push(this.#fields[i].row);
    });
    for (const [name, fields] of groups) {
      const set = parent.appendChild(document.createElement("fieldset"));
      set.appendChild(document.createElement("legend")).textContent = name.replaceAll("_", " ");
      set.append(...fields);
    }
  }
}
