// SPDX-License-Identifier: MIT
// Mouse, pen and fingers on the picture become the program's pointer: one message for each frame of the page at most,
// presses and releases at once. One finger is the left button; two turn and pinch.

const left = 1;
/// Moves closer together than this wait: a fast screen must not send more than the program takes.
const shortest = 7; // ms
/// How long a finger waits for a second one before it presses.
const patience = 60; // ms
const notchesPerDoubling = 6;

const clamp = (x, low, high) => Math.min(high, Math.max(low, x));

export class Pointer {
  #canvas;
  #picture;
  #send;
  #at = { x: -1, y: -1, time: 0 };
  #keys = { shift: false, ctrl: false, alt: false };
  #buttons = 0;
  #wheel = 0;
  #waiting = false; // for the page's next frame
  #last = 0; // when a move was sent
  #fingers = new Map(); // on the picture: id -> event
  #press = 0; // timer of a finger that may be the first of two
  #turned = { dx: 0, dy: 0 }; // how far two fingers went together
  #spread = 0; // distance of two fingers, 0: not two
  #spent = false; // fingers that are left over after two

  /// `send(message, time)`: the message lacks its number, the tool and its radius.
  constructor(canvas, picture, send) {
    this.#canvas = canvas;
    this.#picture = picture;
    this.#send = send;
    const on = (name, act, options) => canvas.addEventListener(name, act, options);
    on("pointerdown", (e) => this.#down(e));
    on("pointermove", (e) => this.#move(e));
    on("pointerup", (e) => this.#up(e));
    on("pointercancel", (e) => this.#up(e));
    on("pointerleave", (e) => this.#leave(e));
    on("wheel", (e) => this.#turn(e), { passive: false });
    on("contextmenu", (e) => e.preventDefault());
  }

  #down(e) {
    this.#canvas.focus({ preventScroll: true });
    this.#canvas.setPointerCapture(e.pointerId);
    e.preventDefault();
    if (e.pointerType === "touch") return this.#fingerDown(e);
    this.#place(e);
    this.#hold(e.buttons);
  }

  #move(e) {
    if (e.pointerType === "touch") return this.#fingerMove(e);
    this.#place(e);
    if (e.buttons !== this.#buttons)
      this.#hold(e.buttons); // a second button, pressed or let go during a drag
    else this.#soon();
  }

  #up(e) {
    if (e.pointerType === "touch") return this.#fingerUp(e);
    this.#place(e);
    this.#hold(e.buttons);
  }

  #leave(e) {
    if (e.pointerType === "touch" || this.#buttons) return;
    this.#at = { x: -1, y: -1, time: e.timeStamp };
    this.#soon();
  }

  #turn(e) {
    e.preventDefault();
    this.#place(e);
    const pixels = e.deltaMode === WheelEvent.DOM_DELTA_LINE ? 33 : e.deltaMode === WheelEvent.DOM_DELTA_PAGE ? 400 : 1;
    this.#wheel = clamp(this.#wheel - (e.deltaY * pixels) / 100, -10, 10);
    this.#soon();
  }

  // Fingers --------------------------------------------------------------------------------------------------------

  #fingerDown(e) {
    this.#fingers.set(e.pointerId, e);
    if (this.#fingers.size === 1) {
      this.#spent = false;
      this.#place(e);
      this.#press = setTimeout(() => this.#pressNow(), patience);
    } else if (this.#fingers.size === 2 && !this.#spent) {
      clearTimeout(this.#press);
      this.#press = 0;
      if (this.#buttons) this.#hold(0); // what one finger held
      this.#spread = this.#distance();
      this.#placeBetween(e);
    }
  }

  #pressNow() {
    clearTimeout(this.#press);
    this.#press = 0;
    this.#hold(left);
  }

  #fingerMove(e) {
    if (!this.#fingers.has(e.pointerId) || this.#spent) return;
    this.#fingers.set(e.pointerId, e);
    if (this.#spread > 0) {
      const now = this.#distance();
      this.#wheel = clamp(this.#wheel + notchesPerDoubling * Math.log2(now / this.#spread), -10, 10);
      this.#spread = now;
      const { x, y } = this.#at;
      this.#placeBetween(e);
      this.#turned = { dx: this.#turned.dx + this.#at.x - x, dy: this.#turned.dy + this.#at.y - y };
    } else this.#place(e);
    if (!this.#press) this.#soon();
  }

  #fingerUp(e) {
    if (!this.#fingers.delete(e.pointerId)) return;
    if (this.#press) this.#pressNow(); // a short tap
    if (this.#spread > 0) this.#spent = this.#fingers.size > 0;
    this.#spread = 0;
    if (this.#buttons) this.#hold(0);
    if (this.#fingers.size > 0) return;
    this.#spent = false;
    this.#at = { x: -1, y: -1, time: e.timeStamp }; // a lifted finger is nowhere
    this.#soon();
  }

  #distance() {
    const [a, b] = [...this.#fingers.values()];
    return Math.max(1, Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY));
  }

  #placeBetween(e) {
    const [a, b] = [...this.#fingers.values()];
    this.#keep((a.clientX + b.clientX) / 2, (a.clientY + b.clientY) / 2, e);
  }

  // Messages -------------------------------------------------------------------------------------------------------

  #place(e) {
    this.#keep(e.clientX, e.clientY, e);
  }

  #keep(clientX, clientY, e) {
    this.#at = { ...this.#picture.fractions(clientX, clientY), time: e.timeStamp };
    this.#keys = { shift: e.shiftKey, ctrl: e.ctrlKey, alt: e.altKey };
  }

  #hold(buttons) {
    if (buttons === this.#buttons) return this.#soon();
    this.#now(); // to the place first, as the program sees a press where the pointer was last
    this.#buttons = buttons;
    this.#now();
  }

  #soon() {
    if (this.#waiting) return;
    this.#waiting = true;
    requestAnimationFrame(() => this.#frame());
  }

  #frame() {
    if (performance.now() - this.#last < shortest) return void requestAnimationFrame(() => this.#frame());
    this.#waiting = false;
    this.#now();
  }

  #now() {
    this.#last = performance.now();
    let { x, y } = this.#at;
    if (this.#buttons) [x, y] = [clamp(x, 0, 1), clamp(y, 0, 1)]; // what is held stays held beyond the edge
    const wheel = Math.round(this.#wheel * 1000) / 1000;
    this.#wheel = 0;
    const { dx, dy } = this.#turned;
    this.#turned = { dx: 0, dy: 0 };
    if (dx || dy) this.#send({ type: "orbit", dx, dy }, this.#at.time);
    const near = (v) => Math.round(clamp(v, -1, 2) * 1e5) / 1e5;
    const out = x < 0 || x > 1 || y < 0 || y > 1;
    this.#send({ type: "pointer", x: near(x), y: near(y), out, buttons: this.#buttons, wheel, ...this.#keys }, this.#at.time);
  }
}
