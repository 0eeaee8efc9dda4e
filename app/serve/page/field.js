// SPDX-License-Identifier: MIT
// One parameter as a labelled field of the form, by its kind: a switch, a choice, a slider with a number, a text.

const make = (tag, more = {}) => Object.assign(document.createElement(tag), more);
const digits = (x) => String(Number.isInteger(Number(x)) ? x : Number(Number(x).toPrecision(5)));
const numbers = (text) =>
  text
    .split(/[\s,;×]+/)
    .filter(Boolean)
    .map(Number);
const words = (text) => text.split(/[\s,;]+/).filter(Boolean);

/// In the plane the third of three numbers says nothing.
const listed = (v, dim) => (v.length === 3 ? v.slice(0, dim) : v).map(digits).join(", ");

/// How a list of a kind is written in a text field, and read again.
const texts = {
  text: { write: (v) => v, read: (t) => t },
  names: { write: (v) => v.join(", "), read: words },
  reals: { write: listed, read: numbers },
  integers: { write: listed, read: numbers },
};

/// How far the track of a slider is filled.
export const fill = ({ style, min, max, value }) => style.setProperty("--filled", `${(100 * (value - min)) / (max - min)}%`);

/// A range of a few steps is stepped through whole; a wide one in hundredths.
function stepOf(p) {
  if (p.kind === "integer") return 1;
  return 10 ** Math.floor(Math.log10((p.max - p.min) / 100));
}

function flag(p, { id, set }) {
  const box = make("input", { type: "checkbox", id });
  box.addEventListener("change", () => set(box.checked));
  return { parts: [box], write: (v) => (box.checked = v) };
}

function choice(p, { id, set }) {
  const list = make("select", { id });
  list.append(...p.options.map((o, i) => make("option", { value: o, textContent: o, title: p.option_help?.[i] ?? "" })));
  list.addEventListener("change", () => set(list.value));
  return { parts: [list], write: (v) => (list.value = v) };
}

function number(p, { id, set }) {
  const box = make("input", { type: "number", id, step: "any" });
  if (p.min !== null) box.min = p.min;
  if (p.max !== null) box.max = p.max;
  box.addEventListener("change", () => (box.value !== "" && box.checkValidity() ? set(box.valueAsNumber) : box.reportValidity()));
  const ranged = p.min !== null && p.max !== null && p.max > p.min && !p.restart;
  if (!ranged) return { parts: [box], write: (v) => (box.value = digits(v)) };
  const slider = make("input", { type: "range", min: p.min, max: p.max, step: stepOf(p) });
  slider.setAttribute("aria-labelledby", `${id}-label`);
  const show = (v) => {
    slider.value = v;
    fill(slider);
  };
  let waiting = false; // one message for each frame of the page
  slider.addEventListener("input", () => {
    box.value = digits(slider.value);
    fill(slider);
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      set(slider.valueAsNumber);
    });
  });
  return { parts: [box], below: slider, write: (v) => ((box.value = digits(v)), show(v)) };
}

function text(p, { id, dim, set }) {
  const { write, read } = texts[p.kind];
  const box = make("input", { type: "text", id, spellcheck: false });
  box.addEventListener("change", () => {
    const value = read(box.value);
    const wrong = Array.isArray(value) && value.some(Number.isNaN);
    box.setCustomValidity(wrong ? "Numbers, with commas between them" : "");
    if (wrong) box.reportValidity();
    else set(value);
  });
  return { parts: [box], write: (v) => (box.value = write(v, dim)) };
}

const kinds = { flag, choice, real: number, integer: number, text, names: text, reals: text, integers: text };

/// What the ends of a range mean: "0 PIC, 1 FLIP".
const ends = (p) => [p.at_min && `${p.min} ${p.at_min}`, p.at_max && `${p.max} ${p.at_max}`].filter(Boolean).join(", ");

/// {row, show(value, of)}. `of`: the title of the pane that has it, which may change; none if all have. `set(value)` is called
/// when a person changes it.
export function makeField(p, { id, label, of, dim, set }) {
  const field = kinds[p.kind](p, { id, dim, set });
  const row = make("div", { className: "row", title: [p.help, ends(p)].filter(Boolean).join("\n") });
  const title = make("label", { id: `${id}-label`, htmlFor: id, textContent: label });
  const pane = make("span", { className: "of", textContent: of ?? "" });
  if (of) title.append(" ", pane);
  if (p.restart) title.append(" ", make("span", { className: "of", textContent: "starts again" }));
  const value = make("span", { className: "value" });
  value.append(...field.parts);
  if (p.unit) value.append(make("span", { className: "unit", textContent: p.unit }));
  row.append(title, value);
  if (field.below) row.append(field.below);
  const held = () => row.contains(document.activeElement) && document.activeElement.type !== "checkbox";
  // What a person is at stays as it is: an answer that is under way must not move it back.
  const show = (value, of) => {
    if (of && pane.textContent !== of) pane.textContent = of;
    if (!held()) field.write(value);
  };
  return { row, show };
}
