// The playhead of a live simulation: playing runs the simulation, and earlier frames can be shown
// again.
import {Playhead} from './playhead.js';

export class LivePlayhead extends Playhead {
  /**
   * @param send sends a command to the simulation
   */
  constructor(send) {
    super(0);
    this.send = send;
  }

  get atEnd() {
    return this.frame >= this.count - 1;
  }

  play() {
    this.show(this.count - 1);
    this.send({command: 'run'});
  }

  pause() {
    if (!this.playing) return;
    this.playing = false;
    this.notify();
    this.send({command: 'pause'});
  }

  /** Shows another frame. After the last one, the simulation makes new steps. */
  move(frames) {
    if (frames > 0 && Number.isFinite(frames) && this.atEnd)
      this.send({command: 'step', steps: frames});
    else super.move(frames);
  }

  /** Sets the number of frames; shows the last one unless the user looks at an earlier one. */
  grow(count) {
    const follow = this.playing || this.atEnd;
    this.count = count;
    if (count) this.show(follow ? count - 1 : this.frame);
  }

  /** Shows the state of the simulation: {running, perSecond}. */
  update({running, perSecond}) {
    this.playing = running;
    this.knownSpeed = perSecond;
    this.speed = perSecond;
    this.notify();
  }

  notify() {
    if (this.knownSpeed !== undefined && this.knownSpeed !== this.speed) {
      this.knownSpeed = this.speed;
      this.send({command: 'speed', perSecond: this.speed});
    }
    super.notify();
  }
}
