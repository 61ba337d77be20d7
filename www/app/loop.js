// The animation loop, the only clock of the motion.

/** Longest time step, in seconds, even if more time passes between two frames. */
const MAX_STEP = 0.1;

export class Loop {
  #step;
  #render;
  #handle = 0;
  /** @type {number | null} */
  #last = null;

  /**
   * @param {(dt: number) => boolean} step advances time by dt seconds; returns true if the motion goes on
   * @param {() => void} render draws the page
   */
  constructor(step, render) {
    this.#step = step;
    this.#render = render;
    document.addEventListener("visibilitychange", () => (document.hidden ? this.#stop() : this.request()));
  }

  /** Requests one frame. Further frames follow as long as the motion goes on. */
  request() {
    if (this.#handle === 0 && !document.hidden) this.#handle = requestAnimationFrame(this.#frame);
  }

  #frame = (/** @type {number} */ now) => {
    this.#handle = 0;
    const dt = this.#last === null ? 0 : Math.min(Math.max(now - this.#last, 0) / 1000, MAX_STEP);
    const moving = this.#step(dt);
    this.#last = moving ? now : null;
    this.#render();
    if (moving) this.request();
  };

  #stop() {
    cancelAnimationFrame(this.#handle);
    this.#handle = 0;
    this.#last = null;
  }
}
