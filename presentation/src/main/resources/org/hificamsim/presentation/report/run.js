// A run as far as it is known: the set-up, and a list by frame for each quantity. It may still grow.
import {poseAt, seenAt, viewCount} from './views.js';

/** Says which share of the steps is shown. */
export const thinned = (run, every) =>
  `This run has ${run.steps} steps; the page shows one in ${every}`;

const lists = count => Array.from({length: count}, () => []);

export class Run {
  /**
   * @param setup as the record Setup of the simulator
   * @param estimated what the agents' estimates are; empty where they have none
   * @param objective what a step is scored by: the record ObjectiveWords
   */
  constructor(setup, estimated = '', objective = null) {
    this.objective = objective;
    const cameras = setup.cameras.length;
    const targets = setup.targets.length;
    this.setup = setup;
    this.estimated = estimated;
    this.every = 1;
    this.steps = 0;
    this.count = 0;
    this.step = [];
    this.online = lists(cameras);
    this.level = lists(cameras);
    this.detected = lists(cameras);
    this.present = lists(targets);
    this.x = lists(targets);
    this.y = lists(targets);
    this.coverage = lists(targets);
    this.seeing = setup.slow ? lists(cameras) : []; // the view through which a camera sees, -1 while it moves blindly
    this.estimates = setup.cameras.map(camera => lists(viewCount(camera.pose)));
    this.counts = setup.cameras.map(camera => lists(viewCount(camera.pose)));
    this.belief = []; // by frame, as the record BeliefFrame; nothing where cameras believe nothing
    this.poses = setup.cameras.map(camera => [{step: -1, pose: camera.pose}]);
    this.kMin = [];
    this.highest = 0;
    this.most = 1; // targets at the same time
    this.targets = [];
    this.covered = [[], [], [], []];
    this.sum = [];
    this.score = []; // what the objective makes of a frame; empty where that is not known
  }

  /** Adds a frame of a live run: the record Frame, and the records Move of the steps since the frame before. */
  push(frame, moves = [], score = NaN) {
    this.score.push(score);
    this.step.push(frame.step);
    for (const name of ['online', 'level', 'detected', 'present', 'x', 'y', 'coverage']) {
      frame[name].forEach((value, i) => this[name][i].push(value));
    }
    frame.seeing?.forEach((view, i) => this.seeing[i].push(view));
    for (const name of ['estimates', 'counts']) {
      this[name].forEach((views, camera) =>
        views.forEach((list, view) => list.push(frame[name][camera]?.[view] ?? NaN)),
      );
    }
    if (frame.belief) this.belief[this.count] = frame.belief;
    moves.forEach(move => this.move(move));
    this.steps = frame.step + 1;
    this.measure(this.count++);
  }

  /** Goes on under another set-up of the same cameras and targets: what agents knew is forgotten. */
  become(setup, estimated) {
    this.setup = setup;
    if (estimated === this.estimated && !estimated) return;
    this.estimated = estimated;
    for (const all of [this.estimates, this.counts])
      all.forEach(levels => levels.forEach(list => list.fill(NaN)));
  }

  /** Shows a camera in another pose from the last frame on, until the simulation says what it is. */
  preview(camera, change) {
    const poses = this.poses[camera];
    const last = poses[poses.length - 1];
    if (last.preview) poses.pop();
    poses.push({
      step: this.step[this.count - 1] ?? -1,
      pose: {...last.pose, ...change},
      preview: true,
    });
  }

  /** Shows a camera where it was before somebody asked for what was refused. */
  forgetPreview(camera) {
    if (this.poses[camera]?.at(-1).preview) this.poses[camera].pop();
  }

  /** Leaves out every other frame, but not the last one. */
  thin() {
    const rest = (this.count - 1) % 2;
    const half = list => list.filter((value, i) => i % 2 === rest);
    this.step = half(this.step);
    this.belief = Array.from({length: this.step.length}, (none, i) => this.belief[2 * i + rest]);
    for (const name of [
      'online',
      'level',
      'detected',
      'present',
      'x',
      'y',
      'coverage',
      'covered',
      'seeing',
    ])
      this[name] = this[name].map(half);
    for (const name of ['estimates', 'counts'])
      this[name] = this[name].map(levels => levels.map(half));
    for (const name of ['kMin', 'targets', 'sum', 'score']) this[name] = half(this[name]);
    this.count = this.step.length;
    this.every *= 2;
  }

  /** Notes that a camera stands, looks or sees otherwise from a step on. */
  move({step, camera, pose}) {
    this.poses[camera].push({step, pose});
  }

  /** Counts how the targets present are covered in a frame (Eq 7.1). */
  measure(frame) {
    const classes = [0, 0, 0, 0];
    let targets = 0;
    let sum = 0;
    let least = Infinity;
    for (let target = 0; target < this.coverage.length; target++) {
      if (!this.present[target][frame]) continue;
      const k = this.coverage[target][frame];
      targets++;
      sum += k;
      least = Math.min(least, k);
      classes[Math.min(k, 3)]++;
    }
    this.most = Math.max(this.most, targets);
    this.targets[frame] = targets;
    this.sum[frame] = sum;
    this.kMin[frame] = targets ? least : 0;
    this.highest = Math.max(this.highest, this.kMin[frame]);
    classes.forEach((number, i) => (this.covered[i][frame] = number));
  }

  /** The columns of steps.csv in a frame. */
  row(frame) {
    const [none, one, two, more] = this.covered.map(list => list[frame]);
    const targets = this.targets[frame];
    return {
      step: this.step[frame],
      k_min: this.kMin[frame],
      targets,
      covered_0: none,
      covered_1: one,
      covered_k: two + more,
      mean_k: targets ? this.sum[frame] / targets : 0,
    };
  }

  /** Whether there is a score of its own to be shown, next to k_min. */
  get scored() {
    return Boolean(this.objective && !this.objective.kMin && this.score.length);
  }

  /** Where a camera is in a frame. */
  pose(camera, frame) {
    return poseAt(this, camera, frame);
  }

  /** The view through which a camera sees in a frame; -1 while it moves blindly. */
  seen(camera, frame) {
    return seenAt(this, camera, frame);
  }

  /** The camera that has detected most. */
  busiest() {
    const sums = this.detected.map(list => list.reduce((sum, number) => sum + number, 0));
    return sums.indexOf(Math.max(...sums));
  }

  /** The frame of a step, or the last one before it. */
  frameAt(step) {
    let low = 0;
    let high = this.count - 1;
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      if (this.step[middle] <= step) low = middle;
      else high = middle - 1;
    }
    return low;
  }
}
