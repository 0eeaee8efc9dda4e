// SPDX-License-Identifier: MIT
// The connection to the program: opens, hears, says, and opens again by itself. What a message means is for others.

const tokenKey = "flipbook-token";

/// Seconds before the next try, the last one for ever. A lecture hall full of pages must not come back at one moment.
const delays = [0.5, 1, 2, 4, 8];
const slowest = delays.length - 1;
const scattered = (seconds) => seconds * (0.8 + 0.4 * Math.random());

/// What the closing of a connection means: a sentence for people, and from which delay on to try again (none: not at all).
function meaning(code, reason) {
  switch (code) {
    case 1001:
      return { text: "The program has ended.", from: 2 };
    case 1011:
      return { text: reason ? `The run failed: ${reason}.` : "The run failed.", from: slowest };
    case 4401:
      return { text: "This link is not valid", from: null };
    case 4408:
      return { text: "The program gave this page up: it was silent for too long.", from: 0 };
    case 4409:
      return { text: "Too many pages are open.", from: slowest };
    case 4429:
      return { text: "This page sent too much at once.", from: 2 };
    case 1002:
    case 1007:
    case 1009:
    case 4400:
      return { text: "The program did not understand this page. Reload it if that goes on.", from: slowest };
    default:
      return { text: "Connection lost.", from: 0 };
  }
}

/// The key in the address, from then on kept in the tab: an audience can read the address bar.
export function takeToken() {
  const given = new URLSearchParams(location.hash.slice(1)).get("token") ?? new URLSearchParams(location.search).get("token");
  if (given) {
    sessionStorage.setItem(tokenKey, given);
    history.replaceState(null, "", "/");
  }
  return given ?? sessionStorage.getItem(tokenKey) ?? "";
}

/// Events: "status" with {state, text, seconds}, where state is connecting, open, waiting or refused; "picture" with an
/// ArrayBuffer; "said" with a message of the program.
export class Connection extends EventTarget {
  #token;
  #socket = null;
  #tries = 0;
  #timer = 0;
  #lost = ""; // why the last connection ended

  constructor(token) {
    super();
    this.#token = token;
    addEventListener("online", () => this.retry());
    // A new link in the same tab differs after the # only: the browser would not load the page again.
    addEventListener("hashchange", () => location.hash && (takeToken(), location.reload()));
  }

  get isOpen() {
    return this.#socket?.readyState === WebSocket.OPEN;
  }

  open() {
    clearTimeout(this.#timer);
    this.#timer = 0;
    this.#tell("status", { state: "connecting", text: this.#lost ? `${this.#lost} Trying again` : "Connecting" });
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/ws?token=${encodeURIComponent(this.#token)}`);
    socket.binaryType = "arraybuffer";
    this.#socket = socket;
    let opened = false;
    socket.onmessage = ({ data }) => {
      if (!opened) {
        // a connection that is refused was open too: only a word says that it stands
        opened = true;
        this.#tell("status", { state: "open", text: "Connected", again: this.#lost !== "" });
        this.#lost = "";
        this.#tries = 0;
      }
      if (typeof data === "string") this.#tell("said", JSON.parse(data));
      else this.#tell("picture", data);
    };
    socket.onclose = ({ code, reason }) => {
      if (this.#socket !== socket) return;
      const { text, from } = meaning(code, reason);
      if (from === null) return this.#tell("status", { state: "refused", text });
      this.#tries = Math.max(this.#tries, from);
      this.#lost = opened || code !== 1006 ? text : this.#lost || "The program does not answer.";
      this.#wait();
    };
  }

  /// Without waiting for the next try.
  retry() {
    if (this.#timer) this.open();
  }

  say(message) {
    if (!this.isOpen) return false;
    this.#socket.send(JSON.stringify(message));
    return true;
  }

  do(action, more = {}) {
    return this.say({ type: "do", action, ...more });
  }

  #wait() {
    const seconds = scattered(delays[Math.min(this.#tries++, slowest)]);
    this.#timer = setTimeout(() => this.open(), 1000 * seconds);
    this.#tell("status", { state: "waiting", text: this.#lost, seconds });
  }

  #tell(kind, detail) {
    this.dispatchEvent(new CustomEvent(kind, { detail }));
  }
}
