// Which frame is shown, and the clock that moves it; one for all players that are to keep in step.

export const SPEEDS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];
const MAX_PAUSE = 250;

export class Playhead {
  /**
   * @param count frames
   * @param every steps from one frame to the next
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

  /** Calls back with the frame whenever anything about the playhead changes. */
  subscribe(listener) {
    this.listeners.push(listener);
    listener(this.frame);
  }

  /** Shows another frame, as near to it as there is one. */
  show(frame) {
    this.frame = Math.max(0, Math.min(Math.round(frame), this.count - 1));
    this.exact = this.frame;
    this.tell();
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
    this.tell();
    requestAnimationFrame(now => this.tick(now));
  }

  pause() {
    if (!this.playing) return;
    this.playing = false;
    this.tell();
  }

  /** The next faster or slower speed. */
  faster(by) {
    const at = SPEEDS.findIndex(speed => speed >= this.speed);
    this.speed = SPEEDS[Math.max(0, Math.min(at + by, SPEEDS.length - 1))];
    this.tell();
  }

  tick(now) {
    if (!this.playing) return;
    const passed = Math.max(0, Math.min(now - this.before, MAX_PAUSE));
    this.before = now;
    this.exact = Math.min(this.exact + (passed * this.speed) / (1000 * this.every), this.count - 1);
    const frame = Math.floor(this.exact);
    if (frame !== this.frame) {
      this.frame = frame;
      if (frame === this.count - 1) this.playing = false;
      this.tell();
    }
    if (this.playing) requestAnimationFrame(then => this.tick(then));
  }

  tell() {
    const start = performance.now();
    this.listeners.forEach(listener => listener(this.frame));
    const took = performance.now() - start;
    this.drawn.frames++;
    this.drawn.milliseconds += took;
    this.drawn.slowest = Math.max(this.drawn.slowest, took);
  }
}
