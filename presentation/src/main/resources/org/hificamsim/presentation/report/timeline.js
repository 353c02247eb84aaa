// Quantities over time under one playhead: k_min, how targets are covered, and each camera's zoom.
import {el, onThemeChange, rem, say, style, Surface} from './dom.js';
import {COVER, scaleColour, levelShare} from './palette.js';
import {SHOWN_RAW, smoothed} from './smooth.js';
import {viewName, viewOf} from './views.js';
import {scoreNumber} from './names.js';
import {decimals} from './numbers.js';

const GUTTER = 6.5; // rem, as in the style sheet
const RIGHT = 1;

const axis = (extra = {}) => ({
  stroke: () => style('--faint'),
  font: `${0.75 * rem()}px sans-serif`,
  grid: {stroke: () => style('--grid'), width: 1},
  ticks: {stroke: () => style('--grid'), width: 1, size: 4},
  ...extra,
});

/** Steps where every step is shown, straight lines between means. */
function path(plot, ...rest) {
  return (plot.data[0].length > SHOWN_RAW ? uPlot.paths.linear() : uPlot.paths.stepped({align: 1}))(
    plot,
    ...rest,
  );
}

/** A uPlot chart over the steps of a run that shows and sets the playhead. */
class Chart {
  /**
   * @param describe what is said about a frame, shown or under the pointer
   */
  constructor(title, label, playhead, describe, series, more) {
    this.playhead = playhead;
    this.describe = describe;
    this.series = series;
    this.more = more;
    this.value = el('span', {class: 'value'});
    this.box = el('div', {class: 'plot', role: 'img', 'aria-label': label});
    this.line = el('div', {class: 'playhead'});
    this.element = el(
      'figure',
      {class: 'chart'},
      el('figcaption', {}, title, this.value),
      this.box,
    );
    new ResizeObserver(() => requestAnimationFrame(() => this.fit())).observe(this.box);
    onThemeChange(() => this.plot?.redraw());
  }

  /** Shows other data: the steps, then one list for each series. */
  load(data) {
    this.data = data;
    if (this.plot) this.plot.setData(data);
    else this.fit();
    this.mark();
  }

  fit() {
    const width = this.box.clientWidth;
    const height = this.box.clientHeight;
    if (!width || !height || !this.data) return;
    if (this.plot) this.plot.setSize({width, height});
    else this.make(width, height);
    this.mark();
  }

  make(width, height) {
    this.plot = new uPlot(
      {
        width,
        height,
        legend: {show: false},
        padding: [Math.round(0.6 * rem()), RIGHT * rem(), 0, 0],
        cursor: {drag: {x: false, y: false}, points: {show: false}, y: false, x: false},
        scales: {
          x: {time: false, range: (plot, low, high) => [low, Math.max(high, low + 1)]},
          ...this.more.scales,
        },
        axes: [
          axis({size: 1.7 * rem(), space: 4 * rem()}),
          axis({size: GUTTER * rem(), space: 1.8 * rem(), ...this.more.yAxis}),
        ],
        series: [{}, ...this.series],
        hooks: {draw: [() => this.mark()]},
      },
      this.data,
      this.box,
    );
    this.plot.over.append(this.line);
    const {over} = this.plot;
    scrub(over, this.playhead, x => this.plot.posToIdx(x));
    over.addEventListener('pointermove', event =>
      say(
        this.value,
        this.describe(this.plot.posToIdx(event.clientX - over.getBoundingClientRect().left)),
      ),
    );
    over.addEventListener('pointerleave', () => say(this.value, this.describe(this.frame)));
  }

  show(frame) {
    this.frame = frame;
    say(this.value, this.describe(frame));
    this.mark();
  }

  mark() {
    if (!this.plot || !this.data?.[0].length) return;
    const x = this.plot.valToPos(this.data[0][this.frame || 0], 'x');
    this.line.style.transform = `translateX(${x}px)`;
  }
}

/** Pressing and dragging on an element shows the frame there. */
function scrub(element, playhead, frameAt) {
  const show = event =>
    playhead.show(frameAt(event.clientX - element.getBoundingClientRect().left));
  element.addEventListener('pointerdown', event => {
    playhead.pause();
    element.setPointerCapture(event.pointerId);
    show(event);
  });
  element.addEventListener('pointermove', event => event.buttons & 1 && show(event));
}

/** Each camera's zoom level over time, a row a camera. */
class ZoomStrip {
  constructor(playhead, on) {
    this.playhead = playhead;
    this.on = on;
    this.value = el('span', {class: 'value'});
    this.surface = new Surface(
      {role: 'img', 'aria-label': 'zoom level of each camera over time'},
      (context, width, height) => this.paint(context, width, height),
    );
    this.line = el('div', {class: 'playhead'});
    this.rows = el('div', {class: 'rows', role: 'group', 'aria-label': 'cameras'});
    this.box = el('div', {class: 'strip'}, this.surface.canvas, this.line);
    this.element = el(
      'figure',
      {class: 'chart zooms'},
      el('figcaption', {}, 'zoom of each camera', key(), this.value),
      el('div', {class: 'strip-scroll'}, el('div', {class: 'strip-box'}, this.rows, this.box)),
    );
    scrub(this.box, playhead, x => this.frameAt(x));
    this.box.addEventListener('pointermove', event => this.hover(event));
    this.box.addEventListener('pointerleave', () => say(this.value, ''));
    this.box.addEventListener('click', event => this.on.select(this.cameraAt(event)));
  }

  load(run) {
    if (this.run?.setup !== run.setup) this.name(run);
    this.run = run;
    this.surface.draw();
  }

  name(run) {
    this.rows.replaceChildren(
      ...run.setup.cameras.map((camera, i) =>
        el(
          'button',
          {
            type: 'button',
            title: camera.name,
            'aria-pressed': 'false',
            onclick: () => this.on.select(i),
          },
          camera.name,
        ),
      ),
    );
    this.element.dataset.rows = run.setup.cameras.length;
    this.element.style.setProperty('--rows', run.setup.cameras.length);
  }

  select(camera) {
    [...this.rows.children].forEach((row, i) =>
      row.setAttribute('aria-pressed', String(i === camera)),
    );
  }

  frameAt(x) {
    const first = this.run.step[0];
    const last = this.run.step[this.run.count - 1];
    return this.run.frameAt(first + (x / this.surface.width) * (last - first));
  }

  cameraAt(event) {
    const box = this.box.getBoundingClientRect();
    const row = Math.floor(
      ((event.clientY - box.top) / box.height) * this.run.setup.cameras.length,
    );
    return Math.max(0, Math.min(row, this.run.setup.cameras.length - 1));
  }

  hover(event) {
    if (!this.run.count) return;
    const frame = this.frameAt(event.clientX - this.box.getBoundingClientRect().left);
    const camera = this.cameraAt(event);
    const level = this.run.level[camera][frame];
    const pose = this.run.pose(camera, frame);
    const {zoom, viewingAngle} = viewOf(pose, level);
    const wide = pose.lenses
      ? `${decimals((viewingAngle * 180) / Math.PI, 1)}° wide`
      : `radius ${decimals(pose.levels[zoom].radius, 3)} m`;
    const text = this.run.online[camera][frame]
      ? `${viewName(pose, level)}, ${wide}, detects ${this.run.detected[camera][frame]}`
      : 'not online';
    say(
      this.value,
      `${this.run.setup.cameras[camera].name}, step ${this.run.step[frame]}: ${text}`,
    );
  }

  /** One pixel column after the other: the mean level of the frames in it. */
  paint(context, width, height) {
    const {run} = this;
    if (!run?.count) return;
    const cameras = run.setup.cameras.length;
    const columns = this.surface.canvas.width;
    const image = new ImageData(columns, cameras);
    const first = run.step[0];
    const perColumn = (run.step[run.count - 1] - first + 1) / columns;
    for (let column = 0; column < columns; column++) {
      const from = run.frameAt(first + column * perColumn);
      const to = Math.max(from, run.frameAt(first + (column + 1) * perColumn - 1e-9));
      for (let camera = 0; camera < cameras; camera++) {
        paintCell(image, column, camera, meanLevel(run, camera, from, to));
      }
    }
    const rows = document.createElement('canvas');
    [rows.width, rows.height] = [columns, cameras];
    rows.getContext('2d').putImageData(image, 0, 0);
    context.imageSmoothingEnabled = false;
    context.drawImage(rows, 0, 0, width, height);
    context.fillStyle = style('--paper');
    for (let camera = 1; camera < cameras; camera++)
      context.fillRect(0, (camera * height) / cameras - 0.5, width, 1);
    this.show(this.frame || 0);
  }

  show(frame) {
    this.frame = frame;
    if (!this.run?.count || !this.surface.width) return;
    const first = this.run.step[0];
    const last = this.run.step[this.run.count - 1];
    const x =
      last > first ? ((this.run.step[frame] - first) / (last - first)) * this.surface.width : 0;
    this.line.style.transform = `translateX(${x}px)`;
  }
}

/** The mean place between narrowest and widest, 0 to 1; NaN where the camera was never online. */
function meanLevel(run, camera, from, to) {
  const levels = run.level[camera];
  const most = run.setup.cameras[camera].pose.levels.length;
  let sum = 0;
  let count = 0;
  for (let frame = from; frame <= to; frame++) {
    if (!run.online[camera][frame]) continue;
    sum += levelShare(levels[frame] % most, most);
    count++;
  }
  return sum / count;
}

function paintCell(image, column, row, share) {
  if (Number.isNaN(share)) return;
  const at = 4 * (row * image.width + column);
  image.data.set([...scaleColour(share), 255], at);
}

function key() {
  const stops = [0, 0.25, 0.5, 0.75, 1].map(share => {
    const swatch = el('i', {class: 'swatch'});
    swatch.style.background = `rgb(${scaleColour(share).join()})`;
    return swatch;
  });
  return el('span', {class: 'key'}, 'narrow', ...stops, 'wide');
}

/** A quantity by step, pale, and what it tends to. */
const curve = () => [
  {
    stroke: () => style('--faint'),
    width: 1,
    alpha: 0.35,
    points: {show: false},
    paths: uPlot.paths.stepped({align: 1}),
  },
  {stroke: () => style('--accent'), width: 2.2, points: {show: false}, paths: path},
];

/** All that is shown over time. */
export class Timeline {
  /**
   * @param on `select(camera)`, `objective` of the run, `ceiling()`
   */
  constructor(playhead, on) {
    this.kMin = new Chart(
      'k_min, the least number of cameras that cover a target (cameras)',
      'k_min over time',
      playhead,
      frame => this.tellKMin(frame),
      curve(),
      {
        scales: {
          y: {range: (plot, low, high) => [0, Math.max(1, high, on.ceiling?.() ?? 0) * 1.04]},
        },
        yAxis: {incrs: [1, 2, 5, 10, 20, 50]},
      },
    );
    this.score =
      on.objective && !on.objective.kMin ? this.scoreChart(on.objective, playhead) : null;
    const areas = COVER.map(cover => ({
      stroke: cover.colour,
      fill: cover.colour,
      width: 0,
      points: {show: false},
      paths: path,
    }));
    this.cover = new Chart(
      'targets covered by none, 1, 2, 3 or more cameras (% of targets)',
      'share of targets by number of cameras over time',
      playhead,
      frame => this.tellCover(frame),
      [...areas].reverse(),
      {
        scales: {y: {range: [0, 1]}},
        yAxis: {values: (plot, values) => values.map(value => `${Math.round(100 * value)} %`)},
      },
    );
    this.zooms = new ZoomStrip(playhead, on);
    this.element = el(
      'section',
      {class: 'timeline', 'aria-label': 'over time'},
      this.score?.element,
      this.kMin.element,
      this.cover.element,
      this.zooms.element,
    );
  }

  scoreChart({title, share}, playhead) {
    return new Chart(
      title,
      `${title}, over time`,
      playhead,
      frame => this.tellScore(frame),
      curve(),
      {
        scales: {y: {range: (plot, low, high) => [0, share ? 1 : Math.max(1, high) * 1.04]}},
        yAxis: {
          values: (plot, values) =>
            values.map(value => (share ? `${Math.round(100 * value)} %` : value)),
        },
      },
    );
  }

  /** Shows a run, or what has been added to it. */
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
    this.zooms.load(run);
  }

  select(camera) {
    this.zooms.select(camera);
  }

  show(frame) {
    if (!this.run?.count) return;
    [this.score, this.kMin, this.cover, this.zooms].forEach(part => part?.show(frame));
  }

  tellScore(frame) {
    return this.run.scored
      ? `step ${this.run.step[frame]}: ${scoreNumber(this.run.score[frame], this.run.objective)}`
      : '';
  }

  tellKMin(frame) {
    return `step ${this.run.step[frame]}: ${this.run.kMin[frame]}`;
  }

  tellCover(frame) {
    const parts = COVER.map(({label}, i) => `${label} ${this.run.covered[i][frame]}`);
    return `step ${this.run.step[frame]}: ${parts.join(', ')}`;
  }
}
