// SPDX-License-Identifier: MIT
// The page: joins connection, picture, pointer, keys, bar and dialogs. `flipbook serve` sends it; docs: app/serve/README.md.
import { Bar } from "./bar.js";
import { Chooser } from "./chooser.js";
import { Connection, takeToken } from "./connection.js";
import { Keys } from "./keys.js";
import { Messages } from "./messages.js";
import { Parameters } from "./parameters.js";
import { Picture } from "./picture.js";
import { Pointer } from "./pointer.js";

const $ = (id) => document.getElementById(id);

const connection = new Connection(takeToken());
const messages = new Messages($("message"), $("dismiss"));
const picture = new Picture($("picture"), (number) => connection.say({ type: "ack", picture: number }));
let state = null;
let role = null;
let clients = 1;
let seq = 0;

const driving = () => role === "driver";
const act = (action, more) => (driving() || action === "drive" || action === "parameters" ? connection.do(action, more) : false);

// Parameters ----------------------------------------------------------------------------------------------------------

const parameters = new Parameters((path, value, pane) => {
  act("set", pane === undefined ? { path, value } : { path, value, pane });
});
/// Those of the view give the colours and the camera; all of them follow while the form is open.
const askParameters = () => act("parameters", { on: !$("parameters").hidden });

function toggleParameters() {
  const open = $("parameters").hidden;
  $("parameters").hidden = !open;
  $("parameters-toggle").setAttribute("aria-expanded", String(open));
  askParameters();
  if (open) {
    $("parameters-close").focus();
  } else $("parameters-toggle").focus();
}

function turnCamera(path, change) {
  const p = parameters.view(path);
  if (!p || !driving()) return;
  const value = change(p.value);
  parameters.expect(path, value);
  act("set", { path, value });
}

// Controls ------------------------------------------------------------------------------------------------------------

const chooser = new Chooser((kind, name) => act("open", { kind, name }));
const bar = new Bar({ do: act, choose: () => driving() && state && chooser.show(state), parameters: toggleParameters });

/// Numbers rise by one for each message of pointer and keys; a picture says which it has seen.
function input(message, time) {
  if (!driving()) return;
  seq = (seq + 1) >>> 0;
  if (connection.say({ ...message, seq })) picture.sent(seq, time);
}

new Pointer($("picture"), picture, (message, time) => {
  input(message.type === "pointer" ? { ...message, tool: bar.tool, radius: bar.radius } : message, time);
});

function bare() {
  $("bar").hidden = !$("bar").hidden;
}

const keys = new Keys(
  $("picture"),
  [
    { key: "Space", text: "Start or pause", run: () => bar.start() },
    { key: "n", shown: "N", text: "One frame further", run: () => act("step"), repeats: true },
    { key: "Home", text: "Reset to the first frame", run: () => act("reset") },
    { key: "r", shown: "R", text: "Record, stop recording", run: () => bar.record() },
    { key: "p", shown: "P", text: "Snapshot: a PNG of the picture", run: () => act("snapshot") },
    { key: "s", shown: "S", text: "Save as study", run: () => act("save_study") },
    { key: "o", shown: "O", text: "Choose a scene or study", run: () => $("choose").click() },
    ...["camera", "push", "add", "remove", "solid"].map((tool, i) => ({
      key: String(i + 1),
      text: ["Panel and camera", "Push", "Add", "Remove", "Drag a solid"][i],
      run: () => bar.take(tool),
    })),
    { key: "[", shown: "[ ]", text: "Smaller, larger tool", run: () => bar.wider(0.8), repeats: true },
    { key: "]", run: () => bar.wider(1.25), repeats: true },
    { key: "l", shown: "L", text: "Link the panes, or not", run: () => bar.link() },
    { key: "e", shown: "E", text: "Parameters as a form", run: toggleParameters },
    { key: "f", shown: "F", text: "Full screen", run: () => bar.full() },
    { key: "b", shown: "B", text: "Hide or show the bar", run: bare },
    { key: "?", text: "This help", run: () => $("helper").showModal() },
  ],
  { state: () => state, send: (key) => input(key, performance.now()), camera: turnCamera },
);
keys.explain($("keys"), $("shortcuts"));

$("help").addEventListener("click", () => $("helper").showModal());
$("parameters-close").addEventListener("click", toggleParameters);
$("retry").addEventListener("click", () => connection.retry());
$("absent-retry").addEventListener("click", () => connection.retry());
for (const dialog of document.querySelectorAll("dialog")) {
  dialog.addEventListener("click", (e) => e.target === dialog && dialog.close()); // beside it
  for (const button of dialog.querySelectorAll("[data-close]")) button.addEventListener("click", () => dialog.close());
}

// What the program says -----------------------------------------------------------------------------------------------

function takeRole(message) {
  const before = role;
  role = message.role;
  clients = message.clients ?? clients;
  bar.showRole(message);
  parameters.enable(driving());
  if (driving() && before !== "driver") tellSize();
  if (before === "driver" && !driving()) messages.say("warning", "Somebody else drives now. You go on watching.");
  if (before === "viewer" && driving()) messages.say("info", "You drive now.");
}

const heard = {
  hello(message) {
    role = null;
    clients = 1;
    takeRole(message);
    chooser.fill(message);
    askParameters();
  },
  role: takeRole,
  state(message) {
    const changed = !state || state.name !== message.name || state.edits !== message.edits;
    state = message;
    bar.showState(state);
    if (changed) askParameters();
  },
  parameters(message) {
    parameters.show(message, state?.dim ?? 3);
    const theme = parameters.view("view.theme")?.value ?? "dark";
    document.documentElement.dataset.theme = theme;
    document.querySelector("[name=color-scheme]").content = theme;
    document.querySelector("[name=theme-color]").content = getComputedStyle(document.documentElement).getPropertyValue("--page");
  },
  message: ({ level, text }) => messages.say(level, text),
  saved: ({ text }) => messages.say("info", text),
};

connection.addEventListener("said", ({ detail }) => heard[detail.type]?.(detail));
connection.addEventListener("picture", ({ detail }) => picture.receive(detail));

// Whether there is a connection and a picture -------------------------------------------------------------------------

const stage = $("stage");

function showAbsence(detail) {
  const refused = detail.state === "refused";
  $("absent-title").textContent = refused
    ? "This link is not valid"
    : detail.state === "waiting"
      ? "No connection"
      : "Connecting";
  $("absent-text").textContent = refused
    ? "Every start of the program makes a new link. Open the address that flipbook serve printed last; it ends with #token= and the key."
    : detail.state === "waiting"
      ? `${detail.text} This page tries again by itself.`
      : "Waiting for the first picture.";
  $("absent-retry").hidden = detail.state !== "waiting";
}

connection.addEventListener("status", ({ detail }) => {
  $("connection").dataset.state = detail.state;
  const wait = detail.seconds === undefined ? "" : ` Trying again in ${Math.max(1, Math.round(detail.seconds))} s`;
  $("connection-text").textContent = detail.text + wait;
  $("retry").hidden = detail.state !== "waiting";
  showAbsence(detail);
  if (detail.state === "open") {
    $("announced").textContent = "";
    picture.restart();
    seq = 0;
    if (detail.again) messages.say("info", "Connected again.");
    return;
  }
  $("bar").hidden = false; // it has something to say
  stage.toggleAttribute("data-stale", true);
  if (detail.state === "refused") stage.toggleAttribute("data-empty", true);
  // Read aloud once, not with each try.
  if (role !== null) $("announced").textContent = `${detail.text} This page tries again by itself.`;
  role = null;
  messages.forget();
  bar.rest();
  parameters.enable(false);
});
$("message").addEventListener("shown", ({ detail }) => {
  if (detail === "error" || detail === "warning") $("bar").hidden = false;
});
$("picture").addEventListener("drawn", () => {
  stage.removeAttribute("data-empty");
  stage.removeAttribute("data-stale");
});

/// How large the picture may be, in the screen's own pixels; the program draws for who drives. Who takes over with a phone
/// while others watch does not make the picture on the lecture hall's wall a small one.
function tellSize() {
  if (!driving()) return;
  const { width, height } = stage.getBoundingClientRect();
  const within = (x, low, high) => Math.round(Math.min(high, Math.max(low, x * devicePixelRatio)));
  const size = { width: within(width, 320, 3840), height: within(height, 240, 2160) };
  const now = state?.pictures;
  if (clients > 1 && now && size.width * size.height < now.width * now.height) return;
  // A panel would leave little of a phone's picture to the run; the form is below it.
  connection.say({ type: "view", ...size, panel: !phone.matches });
}
const phone = matchMedia("(max-width: 40rem), (max-height: 30rem)");
let settling = 0;
new ResizeObserver(() => {
  clearTimeout(settling);
  settling = setTimeout(tellSize, 200);
}).observe(stage);

setInterval(() => bar.showNumbers(picture.rate, picture.latency), 500);
stage.toggleAttribute("data-empty", true);
connection.open();
