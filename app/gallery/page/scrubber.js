// SPDX-License-Identifier: MIT
// Pictures behind two sliders: one chooses the value of a parameter, the other the moment. Pictures are loaded when the
// scrubber comes near the window: the chosen value first, then the chosen moment of all values, then the rest.
{
  class Scrubber {
    constructor(root) {
      Object.assign(this, JSON.parse(root.querySelector("script").textContent));
      this.root = root;
      this.image = root.querySelector("img");
      this.about = this.image.alt;
      this.value = root.querySelector("input.value");
      this.moment = root.querySelector("input.time");
      this.button = root.querySelector(".play");
      this.pictures = new Map(); // number -> Image
      this.playing = false;
      this.value.addEventListener("input", () => this.show());
      this.moment.addEventListener("input", () => {
        this.pause();
        this.show();
      });
      this.button.addEventListener("click", () => (this.playing ? this.pause() : this.play()));
      root.querySelector(".dials").hidden = false;
      const near = new IntersectionObserver(([entry]) => {
        if (!entry.isIntersecting) return;
        near.disconnect();
        this.loadAll();
      }, { rootMargin: "50%" });
      near.observe(root);
      new IntersectionObserver(([entry]) => !entry.isIntersecting && this.pause()).observe(root);
      this.show();
    }

    get v() {
      return this.value.valueAsNumber;
    }
    get k() {
      return this.moment.valueAsNumber;
    }
    number(v, k) {
      return v * this.times.length + k;
    }

    picture(n) {
      if (!this.pictures.has(n)) {
        const picture = new Image();
        picture.src = this.files[n];
        this.pictures.set(n, picture);
      }
      return this.pictures.get(n);
    }

    /// A few at a time, so that what is asked for by the sliders is not behind all the others.
    async loadAll() {
      const range = (n) => [...Array(n).keys()];
      const order = new Set([
        ...range(this.times.length).map((k) => this.number(this.v, k)),
        ...range(this.values.length).map((v) => this.number(v, this.k)),
        ...range(this.files.length),
      ]);
      const queue = [...order];
      const worker = async () => {
        for (let n; (n = queue.shift()) !== undefined; ) await this.picture(n).decode().catch(() => {});
      };
      await Promise.all(range(4).map(worker));
      this.root.dataset.loaded = "";
    }

    async show() {
      const { v, k } = this;
      const time = `${this.times[k].toFixed(2)} s`;
      const value = `${this.values[v]}${this.unit ? ` ${this.unit}` : ""}`;
      this.root.querySelector(".reading .title").textContent = this.titles[v];
      this.root.querySelector(".reading .time").textContent = `t = ${time}`;
      this.value.setAttribute("aria-valuetext", `${value}: ${this.titles[v]}`);
      this.moment.setAttribute("aria-valuetext", time);
      for (const input of [this.value, this.moment]) input.style.setProperty("--filled", `${(100 * input.valueAsNumber) / input.max}%`);
      this.root.querySelectorAll(".ticks span").forEach((tick, i) => tick.classList.toggle("here", i === v));
      const wanted = this.number(v, k);
      const picture = this.picture(wanted);
      await picture.decode().catch(() => {}); // the old picture stays until the new one can be shown at once
      if (wanted !== this.number(this.v, this.k)) return; // the sliders went on
      this.image.src = picture.src;
      this.image.alt = `${this.titles[v]} at ${time}. ${this.about}`;
    }

    play() {
      this.playing = true;
      this.root.dataset.playing = "";
      this.button.setAttribute("aria-label", "Pause");
      if (this.k === this.times.length - 1) this.moment.value = 0;
      const first = performance.now() - ((1000 * this.seconds) / (this.times.length - 1)) * this.k;
      const step = (now) => {
        if (!this.playing) return;
        const at = ((now - first) / 1000 / this.seconds) * (this.times.length - 1);
        const k = Math.floor(at) % (this.times.length + 4); // the last moment stays a little
        const next = Math.min(k, this.times.length - 1);
        if (next !== this.k) {
          this.moment.value = next;
          this.show();
        }
        requestAnimationFrame(step);
      };
      requestAnimationFrame(step);
    }

    pause() {
      this.playing = false;
      delete this.root.dataset.playing;
      this.button.setAttribute("aria-label", "Play");
    }
  }

  for (const root of document.querySelectorAll(".scrubber")) new Scrubber(root);
}
