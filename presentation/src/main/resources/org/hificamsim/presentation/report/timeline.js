// Charts over the steps of a run: the score, k_min, coverage of targets, each camera's zoom, and
// which camera had each target.
import {Chart, curveSeries, linePath} from './chart.js';
import {el} from './dom.js';
import {scoreNumber} from './names.js';
import {COVER} from './palette.js';
import {smoothed} from './smooth.js';
import {TargetStrip} from './target-strip.js';
import {isStill} from './views.js';
import {ZoomStrip} from './zoom-strip.js';

export class Timeline {
  /**
   * @param options `select(camera)`, called after a click; the `objective` of the run; `ceiling()`
   *   as in Player; `following`, whether the run says which camera has each target
   */
  constructor(playhead, options) {
    this.kMin = new Chart(
      playhead,
      {
        title: 'k_min, the least number of cameras that cover a target (cameras)',
        label: 'k_min over time',
        describe: frame => this.describeKMin(frame),
      },
      curveSeries(),
      {
        scales: {
          y: {range: (plot, low, high) => [0, Math.max(1, high, options.ceiling?.() ?? 0) * 1.04]},
        },
        yAxis: {incrs: [1, 2, 5, 10, 20, 50]},
      },
    );
    this.score =
      options.objective && !options.objective.kMin
        ? this.scoreChart(options.objective, playhead)
        : null;
    const areas = COVER.map(cover => ({
      stroke: cover.colour,
      fill: cover.colour,
      width: 0,
      points: {show: false},
      paths: linePath,
    }));
    this.cover = new Chart(
      playhead,
      {
        title: 'targets covered by none, 1, 2, 3 or more cameras (% of targets)',
        label: 'share of targets by number of cameras over time',
        describe: frame => this.describeCover(frame),
      },
      [...areas].reverse(),
      {
        scales: {y: {range: [0, 1]}},
        yAxis: {values: (plot, values) => values.map(value => `${Math.round(100 * value)} %`)},
      },
    );
    this.zooms = new ZoomStrip(playhead, options);
    this.holders = options.following ? new TargetStrip(playhead, options) : null;
    this.element = el(
      'section',
      {class: 'timeline', 'aria-label': 'over time'},
      this.score?.element,
      this.kMin.element,
      this.cover.element,
      this.zooms.element,
      this.holders?.element,
    );
  }

  scoreChart({title, share}, playhead) {
    return new Chart(
      playhead,
      {title, label: `${title}, over time`, describe: frame => this.describeScore(frame)},
      curveSeries(),
      {
        scales: {y: {range: (plot, low, high) => [0, share ? 1 : Math.max(1, high) * 1.04]}},
        yAxis: {
          values: (plot, values) =>
            values.map(value => (share ? `${Math.round(100 * value)} %` : value)),
        },
      },
    );
  }

  /** Shows a run, with all frames that it has so far. */
  load(run) {
    this.run = run;
    const steps = run.step.slice();
    this.kMin.load([steps, run.kMin.slice(), smoothed(run.kMin)]);
    if (run.scored) this.score.load([steps, run.score.slice(), smoothed(run.score)]);
    const shares = run.covered.map(list =>
      smoothed(list.map((number, i) => (run.targets[i] ? number / run.targets[i] : 0))),
    );
    const stacked = shares.map((share, i) =>
      share.map((value, j) => shares.slice(0, i + 1).reduce((sum, list) => sum + list[j], 0)),
    );
    this.cover.load([steps, ...stacked.reverse()]);
    this.zooms.element.hidden = isStill(run.setup);
    this.zooms.load(run);
    this.holders?.load(run);
  }

  select(camera) {
    this.zooms.select(camera);
    this.holders?.select(camera);
  }

  show(frame) {
    if (!this.run?.count) return;
    [this.score, this.kMin, this.cover, this.zooms, this.holders].forEach(part =>
      part?.show(frame),
    );
  }

  describeScore(frame) {
    return this.run.scored
      ? `step ${this.run.step[frame]}: ${scoreNumber(this.run.score[frame], this.run.objective)}`
      : '';
  }

  describeKMin(frame) {
    return `step ${this.run.step[frame]}: ${this.run.kMin[frame]}`;
  }

  describeCover(frame) {
    const parts = COVER.map(({label}, i) => `${label} ${this.run.covered[i][frame]}`);
    return `step ${this.run.step[frame]}: ${parts.join(', ')}`;
  }
}
