// A run as far as it is known: its setup, and for each quantity a list with a value for each frame.
import {poseAt, seenAt, viewCount} from './views.js';

/** Says which share of the steps is shown. */
export const thinned = (run, every) =>
  `This run has ${run.steps} steps; the page shows one in ${every}`;

const lists = count => Array.from({length: count}, () => []);

export class Run {
  /**
   * @param setup the record Setup
   * @param estimated the quantity that the agents estimate; empty if they estimate nothing
   * @param objective the objective that steps are scored by: the record ObjectiveWords
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
    this.seeing = setup.slow ? lists(cameras) : []; // the view of each camera, -1 while it turns
    this.holders = setup.following ? lists(targets) : []; // of each target, -1 for none
    this.estimates = setup.cameras.map(camera => lists(viewCount(camera.pose)));
    this.counts = setup.cameras.map(camera => lists(viewCount(camera.pose)));
    this.belief = []; // by frame: the record BeliefFrame, if there is one
    this.poses = setup.cameras.map(camera => [{step: -1, pose: camera.pose}]);
    this.kMin = [];
    this.highestKMin = 0;
    this.mostTargets = 1; // present at the same time
    this.targets = [];
    this.covered = [[], [], [], []];
    this.sum = [];
    this.score = []; // by frame; empty if it is not known
  }

  /** Adds a record Frame of a live run, with the records Move of the steps since the last frame. */
  push(frame, moves = [], score = NaN) {
    this.score.push(score);
    this.step.push(frame.step);
    for (const name of ['online', 'level', 'detected', 'present', 'x', 'y', 'coverage']) {
      frame[name].forEach((value, i) => this[name][i].push(value));
    }
    frame.seeing?.forEach((view, i) => this.seeing[i].push(view));
    frame.holders?.forEach((camera, i) => this.holders[i].push(camera));
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

  /**
   * Changes the setup for the next steps; cameras and targets have to be the same. Deletes the
   * agents' estimates so far, because another policy made them.
   */
  changeSetup(setup, estimated) {
    this.setup = setup;
    if (estimated === this.estimated && !estimated) return;
    this.estimated = estimated;
    for (const cameras of [this.estimates, this.counts])
      cameras.forEach(views => views.forEach(list => list.fill(NaN)));
  }

  /** Changes a camera's pose from the last frame on, until the simulation confirms the change. */
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

  /** Takes back the preview of a change that the simulation refused. */
  forgetPreview(camera) {
    if (this.poses[camera]?.at(-1).preview) this.poses[camera].pop();
  }

  /** Removes every other frame but keeps the last one. */
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
      'holders',
    ])
      this[name] = this[name].map(half);
    for (const name of ['estimates', 'counts'])
      this[name] = this[name].map(views => views.map(half));
    for (const name of ['kMin', 'targets', 'sum', 'score']) this[name] = half(this[name]);
    this.count = this.step.length;
    this.every *= 2;
  }

  /** Adds the pose that a camera has from a step on. */
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
    this.mostTargets = Math.max(this.mostTargets, targets);
    this.targets[frame] = targets;
    this.sum[frame] = sum;
    this.kMin[frame] = targets ? least : 0;
    this.highestKMin = Math.max(this.highestKMin, this.kMin[frame]);
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

  /** Whether a score is shown in addition to k_min. */
  get scored() {
    return Boolean(this.objective && !this.objective.kMin && this.score.length);
  }

  /** The pose of a camera in a frame. */
  pose(camera, frame) {
    return poseAt(this, camera, frame);
  }

  /** The view that a camera has in a frame; -1 while it turns and sees nothing. */
  seen(camera, frame) {
    return seenAt(this, camera, frame);
  }

  /** The camera with the most detections. */
  busiest() {
    const sums = this.detected.map(list => list.reduce((sum, number) => sum + number, 0));
    return sums.indexOf(Math.max(...sums));
  }

  /** The frame of a step, or the last frame before it. */
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
