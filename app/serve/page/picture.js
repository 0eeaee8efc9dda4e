// SPDX-License-Identifier: MIT
// The live picture: decodes what the program sends away from the page's own thread, shows the newest, acknowledges, and
// measures how many a second there are and how long a movement of the pointer takes to be seen.

const headerBytes = 24;
const pictureKind = 1;

function read(buffer) {
  const view = new DataView(buffer);
  if (buffer.byteLength <= headerBytes || view.getUint8(0) !== pictureKind) return null;
  const number = (i) => view.getUint32(i, true);
  return {
    number: number(4),
    width: number(8),
    height: number(12),
    input: number(16),
    frame: number(20),
    jpeg: new Blob([new Uint8Array(buffer, headerBytes)], { type: "image/jpeg" }),
  };
}

const median = (values) => {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted.length ? sorted[sorted.length >> 1] : NaN;
};

export class Picture {
  #canvas;
  #surface;
  #acknowledge;
  #drawn = 0; // number of the picture on the screen
  #held = null; // what came while the tab was hidden
  #times = []; // of drawing, over the last second
  #sent = new Map(); // when the pointer was where message `seq` says
  #delays = []; // of the last movements, in ms

  /// `acknowledge(number)` tells the program that a picture is done with.
  constructor(canvas, acknowledge) {
    this.#canvas = canvas;
    this.#surface = canvas.getContext("bitmaprenderer");
    this.#acknowledge = acknowledge;
    document.addEventListener("visibilitychange", () => {
      const held = this.#held;
      this.#held = null;
      if (!document.hidden && held) this.#show(held);
    });
  }

  /// A new connection counts its pictures from the start.
  restart() {
    this.#drawn = 0;
    this.#held = null;
    this.#sent.clear();
  }

  receive(buffer) {
    const picture = read(buffer);
    if (!picture) return;
    // Nobody sees a hidden tab: without an answer the program sends no more until it is shown again.
    if (document.hidden) this.#held = picture;
    else this.#show(picture);
  }

  async #show(picture) {
    let image = null;
    try {
      image = await createImageBitmap(picture.jpeg);
    } catch {
      // A damaged picture is one picture less.
    }
    if (image && picture.number > this.#drawn) {
      this.#drawn = picture.number;
      this.#put(image);
      this.#measure(picture.input);
    } else image?.close(); // a newer one was decoded faster
    this.#acknowledge(picture.number);
  }

  #put(image) {
    const { width, height } = image;
    if (this.#canvas.width !== width || this.#canvas.height !== height) Object.assign(this.#canvas, { width, height });
    this.#surface.transferFromImageBitmap(image);
    const now = performance.now();
    this.#times.push(now);
    while (this.#times[0] < now - 1000) this.#times.shift();
    this.#canvas.dispatchEvent(new Event("drawn"));
  }

  /// The message of this number is about the pointer as it was at `time` (of performance.now()).
  sent(seq, time) {
    this.#sent.set(seq, time);
    if (this.#sent.size > 500) this.#sent.delete(this.#sent.keys().next().value);
  }

  #measure(input) {
    const seen = [];
    for (const [seq, time] of this.#sent) {
      if (seq > input) break;
      seen.push(time);
      this.#sent.delete(seq);
    }
    if (seen.length === 0) return;
    // The screen shows it with the page's next frame, not before.
    requestAnimationFrame(() => {
      const now = performance.now();
      for (const time of seen) {
        this.#delays.push(now - time);
        this.#canvas.dispatchEvent(new CustomEvent("seen", { detail: now - time })); // for tests/bench
      }
      this.#delays.splice(0, this.#delays.length - 60);
    });
  }

  /// Pictures drawn in the last second.
  get rate() {
    const since = performance.now() - 1000;
    return this.#times.filter((t) => t >= since).length;
  }

  /// Median over the last movements of the pointer, in ms; NaN before the first.
  get latency() {
    return median(this.#delays);
  }

  /// Where a point of the window is in the picture, as fractions of it; the letterbox lies outside 0..1.
  fractions(clientX, clientY) {
    const box = this.#canvas.getBoundingClientRect();
    const { width, height } = this.#canvas;
    const scale = Math.min(box.width / width, box.height / height);
    return {
      x: 0.5 + (clientX - box.left - box.width / 2) / (scale * width),
      y: 0.5 + (clientY - box.top - box.height / 2) / (scale * height),
    };
  }
}
