// A chart over the steps of a run that shows the playhead and sets it.
import {el, onThemeChange, rem, setText, style} from './dom.js';
import {MOST_RAW} from './smooth.js';

// Margins in rem, as in the style sheet.
const LEFT = 6.5;
const RIGHT = 1;

const axis = (extra = {}) => ({
  stroke: () => style('--faint'),
  font: `${0.75 * rem()}px sans-serif`,
  grid: {stroke: () => style('--grid'), width: 1},
  ticks: {stroke: () => style('--grid'), width: 1, size: 4},
  ...extra,
});

/** A path for uPlot: a staircase if every step is shown, otherwise lines between means. */
export function linePath(plot, ...rest) {
  const paths =
    plot.data[0].length > MOST_RAW ? uPlot.paths.linear() : uPlot.paths.stepped({align: 1});
  return paths(plot, ...rest);
}

/** Two series for uPlot: a quantity by step, pale, and its moving mean. */
export const curveSeries = () => [
  {
    stroke: () => style('--faint'),
    width: 1,
    alpha: 0.35,
    points: {show: false},
    paths: uPlot.paths.stepped({align: 1}),
  },
  {stroke: () => style('--accent'), width: 2.2, points: {show: false}, paths: linePath},
];

export class Chart {
  /**
   * @param texts `title` and `label` of the chart, and `describe(frame)`, the text for a frame
   * @param series the series without the x axis, as uPlot wants them
   * @param scaling `scales` and `yAxis`, as uPlot wants them
   */
  constructor(playhead, {title, label, describe}, series, scaling) {
    this.playhead = playhead;
    this.describe = describe;
    this.series = series;
    this.scaling = scaling;
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

  /** Shows data: a list of the steps, then one list for each series. */
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
    else this.create(width, height);
    this.mark();
  }

  create(width, height) {
    this.plot = new uPlot(
      {
        width,
        height,
        legend: {show: false},
        padding: [Math.round(0.6 * rem()), RIGHT * rem(), 0, 0],
        cursor: {drag: {x: false, y: false}, points: {show: false}, y: false, x: false},
        scales: {
          x: {time: false, range: (plot, low, high) => [low, Math.max(high, low + 1)]},
          ...this.scaling.scales,
        },
        axes: [
          axis({size: 1.7 * rem(), space: 4 * rem()}),
          axis({size: LEFT * rem(), space: 1.8 * rem(), ...this.scaling.yAxis}),
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
      setText(
        this.value,
        this.describe(this.plot.posToIdx(event.clientX - over.getBoundingClientRect().left)),
      ),
    );
    over.addEventListener('pointerleave', () => setText(this.value, this.describe(this.frame)));
  }

  show(frame) {
    this.frame = frame;
    setText(this.value, this.describe(frame));
    this.mark();
  }

  /** Moves the line of the playhead. */
  mark() {
    if (!this.plot || !this.data?.[0].length) return;
    const x = this.plot.valToPos(this.data[0][this.frame || 0], 'x');
    this.line.style.transform = `translateX(${x}px)`;
  }
}

/**
 * Shows the frame at which an element is pressed, and follows the pointer while it is dragged.
 * @param frameAt returns the frame at an x coordinate of the element, in CSS pixels
 */
export function scrub(element, playhead, frameAt) {
  const show = event =>
    playhead.show(frameAt(event.clientX - element.getBoundingClientRect().left));
  element.addEventListener('pointerdown', event => {
    playhead.pause();
    element.setPointerCapture(event.pointerId);
    show(event);
  });
  element.addEventListener('pointermove', event => event.buttons & 1 && show(event));
}
