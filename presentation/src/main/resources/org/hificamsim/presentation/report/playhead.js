// The frame that is shown, and the clock that advances it. Players that share a playhead show the
// same frame.

export const SPEEDS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];
const MAX_TICK = 250; // milliseconds; if the page pauses for longer, the frames do not jump

export class Playhead {
  /**
   * @param count the number of frames
   * @param every the number of steps from one frame to the next
   */
  constructor(count = 0, every = 1) {
    this.count = count;
    this.every = every;
    this.frame = 0;
    this.playing = false;
    this.speed = 10;
    this.listeners = [];
    this.drawn = {frames: 0, milliseconds: 0, slowest: 0};
  }

  /**
   * Calls a listener with the frame now, and whenever the frame, the speed or `playing` changes.
   */
  subscribe(listener) {
    this.listeners.push(listener);
    listener(this.frame);
  }

  /** Shows a frame, or the nearest one that exists. */
  show(frame) {
    this.frame = Math.max(0, Math.min(Math.round(frame), this.count - 1));
    this.exact = this.frame;
    this.notify();
  }

  move(frames) {
    this.pause();
    this.show(this.frame + frames);
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  play() {
    if (this.playing || this.count < 2) return;
    if (this.frame === this.count - 1) this.show(0);
    this.playing = true;
    this.exact = this.frame;
    this.before = performance.now();
    this.notify();
    requestAnimationFrame(now => this.tick(now));
  }

  pause() {
    if (!this.playing) return;
    this.playing = false;
    this.notify();
  }

  /** Changes the speed by a number of entries in SPEEDS; negative numbers make it slower. */
  changeSpeed(steps) {
    const index = SPEEDS.findIndex(speed => speed >= this.speed);
    this.speed = SPEEDS[Math.max(0, Math.min(index + steps, SPEEDS.length - 1))];
    this.notify();
  }

  tick(now) {
    if (!this.playing) return;
    const passed = Math.max(0, Math.min(now - this.before, MAX_TICK));
    this.before = now;
    this.exact = Math.min(this.exact + (passed * this.speed) / (1000 * this.every), this.count - 1);
    const frame = Math.floor(this.exact);
    if (frame !== this.frame) {
      this.frame = frame;
      if (frame === this.count - 1) this.playing = false;
      this.notify();
    }
    if (this.playing) requestAnimationFrame(then => this.tick(then));
  }

  notify() {
    const start = performance.now();
    this.listeners.forEach(listener => listener(this.frame));
    const took = performance.now() - start;
    this.drawn.frames++;
    this.drawn.milliseconds += took;
    this.drawn.slowest = Math.max(this.drawn.slowest, took);
  }
}
