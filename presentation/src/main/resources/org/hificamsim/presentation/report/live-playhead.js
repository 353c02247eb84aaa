// A playhead over steps that are still being made: playing is the simulation's, the past can be scrubbed.
import {Playhead} from './playhead.js';

export class LivePlayhead extends Playhead {
  /**
   * @param send hands a command to the simulation
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
    this.tell();
    this.send({command: 'pause'});
  }

  /** Steps on from the last frame are made; all others are known. */
  move(frames) {
    if (frames > 0 && Number.isFinite(frames) && this.atEnd)
      this.send({command: 'step', steps: frames});
    else super.move(frames);
  }

  /** There are more frames now: the last one is shown unless somebody looks at an earlier one. */
  grow(count) {
    const follow = this.playing || this.atEnd;
    this.count = count;
    if (count) this.show(follow ? count - 1 : this.frame);
  }

  /** What the simulation says. */
  told({running, perSecond}) {
    this.playing = running;
    this.speedTold = perSecond;
    this.speed = perSecond;
    this.tell();
  }

  tell() {
    if (this.speedTold !== undefined && this.speedTold !== this.speed) {
      this.speedTold = this.speed;
      this.send({command: 'speed', perSecond: this.speed});
    }
    super.tell();
  }
}
