// The chart of the score over time. Policies differ by colour and detection models by dashes;
// intervals are bands, and the lines of yardsticks have names at their ends.
import {card, labelledSelect} from './cards.js';
import {onDark} from './contrast.js';
import {el, isDark, onThemeChange, rem, style} from './dom.js';
import {spelled} from './names.js';
import {decimals, percent} from './numbers.js';
import {distinct, rowsOf} from './table.js';
import {OPTIMAL} from './yardsticks.js';

/** The dashes of detection models, on canvas and as a border style in the legend. */
const DASHES = [
  {line: [], borderStyle: 'solid'},
  {line: [8, 4], borderStyle: 'dashed'},
  {line: [2, 4], borderStyle: 'dotted'},
  {line: [10, 3, 2, 3], borderStyle: 'double'},
];
const ALL = 'all';
const MOST_LINES = 12;
const MOST_BANDS = 3;
const DECIMALS = 4;
const HEIGHT = 26; // rem

export function scoreOverTime({levels, colours, settings, yardsticks}) {
  const cases = casesOf(rowsOf(levels));
  const scenarios = distinct(cases, 'scenario');
  const scenario = labelledSelect('scenario', scenarios, scenarios[0], () => draw());
  const box = el('div', {
    class: 'lines',
    role: 'img',
    'aria-label': 'score over time by case; the tables have the numbers',
  });
  const detections = distinct(cases, 'detection');
  const detection = detectionChoice(cases, detections, () => draw());
  const banded = cases.some(({parts}) => parts[0].low !== '');
  let plot;

  function draw() {
    const isShown = name => [ALL, name].includes(detection.value);
    const shown = byScore(
      cases.filter(entry => entry.scenario === scenario.value && isShown(entry.detection)),
    );
    const bands = bandsOf(shown);
    const named = isSingle() ? shown : []; // yardsticks of several detections have the same names
    const lines = named.length ? yardstickLines(yardsticks, settings, named[0]) : [];
    const greatest = Math.max(
      0,
      ...bands.flatMap(band => band?.high ?? []),
      ...lines.map(({score}) => score),
    );
    const {score_words: title, score_unit: unit} =
      settings?.find(entry => entry.scenario === scenario.value) ?? {};
    const share = unit === 'share';
    const top = high => 1.05 * Math.max(high, greatest) || 1;
    const hasNames = lines.length || named.some(({policy}) => policy === OPTIMAL);
    plot?.destroy();
    plot = new uPlot(
      {
        width: box.clientWidth || 600,
        height: HEIGHT * rem(),
        padding: [8, (hasNames ? 5.5 : 1) * rem(), 0, 0],
        cursor: {drag: {x: true, y: false}},
        scales: {
          x: {time: false},
          y: {range: (chart, low, high) => [0, share ? Math.min(1, top(high)) : top(high)]},
        },
        axes: [
          axis({size: 2.2 * rem(), space: 5 * rem(), label: 'step'}),
          axis({
            size: 3.5 * rem(),
            space: 2 * rem(),
            label: title ?? 'k_min (cameras)',
            values: (chart, ticks) => ticks.map(tick => (share ? percent(tick) : tick)),
          }),
        ],
        hooks: {
          drawAxes: [chart => drawBands(chart, bands)],
          draw: [chart => nameYardsticks(chart, named, lines)],
        },
        series: [
          {label: 'step', value: (chart, step) => step ?? ''},
          ...shown.map((entry, i) => series(entry, share, dashOf(shown, i).line)),
        ],
        legend: {markers: {dash: (chart, i) => (i ? dashOf(shown, i - 1).borderStyle : 'solid')}},
      },
      [
        shown[0].parts.map(({step}) => Number(step)),
        ...shown.map(({parts}) => parts.map(({score}) => Number(score))),
      ],
      box,
    );
  }

  const isSingle = () => detections.length === 1 || detection.value !== ALL;
  /** The dashes tell detections apart, and those of one detection that have the same colour. */
  function dashOf(shown, i) {
    const {policy, detection: name} = shown[i];
    const alike = shown.slice(0, i).filter(entry => colours[entry.policy] === colours[policy]);
    return DASHES[(isSingle() ? alike.length : detections.indexOf(name)) % DASHES.length];
  }

  const series = ({policy, detection: name}, share, dash) => ({
    label: isSingle() ? spelled(policy) : `${spelled(policy)}; ${spelled(name)}`,
    stroke: policy === OPTIMAL ? () => style('--ink') : () => lineColour(colours[policy]),
    width: 0.12 * rem(),
    dash,
    points: {show: false},
    value: (chart, value) =>
      value == null ? '' : share ? percent(value) : decimals(value, DECIMALS),
  });
  new ResizeObserver(() =>
    requestAnimationFrame(() => {
      if (!plot) draw();
      else if (box.clientWidth) plot.setSize({width: box.clientWidth, height: HEIGHT * rem()});
    }),
  ).observe(box);
  onThemeChange(() => plot && draw());
  const note =
    'Mean over the seeds' +
    (banded ? `, with the 95 % intervals of the ${MOST_BANDS} highest as bands` : '') +
    '; a point is one of fifty equal parts of the run, or a step where there are fewer. ' +
    'Hover for numbers, click names to hide lines, drag to zoom in, double-click to zoom out.';
  return card(
    'Score over time',
    el('p', {class: 'pick'}, scenario.label, detections.length > 1 ? detection.label : null),
    box,
    el('p', {class: 'note'}, note),
  );
}

/** Returns the choice of a detection, at first the last; "all" if the lines are few enough. */
function detectionChoice(cases, detections, draw) {
  const lines = cases.length / distinct(cases, 'scenario').length;
  const areFew = detections.length <= DASHES.length && lines <= MOST_LINES;
  const choices = areFew ? [ALL, ...detections] : detections;
  return labelledSelect('detection', choices, detections.at(-1), draw, spelled);
}

/** Groups rows by case. The rows of a case have to follow each other. */
function casesOf(rows) {
  const cases = [];
  const isSame = (row, entry) =>
    ['scenario', 'detection', 'policy'].every(name => row[name] === entry[name]);
  for (const row of rows) {
    if (!cases.length || !isSame(row, cases.at(-1))) {
      const {scenario, detection, policy} = row;
      cases.push({scenario, detection, policy, parts: []});
    }
    cases.at(-1).parts.push(row);
  }
  return cases;
}

/** Cases by their score, the highest first. */
function byScore(cases) {
  const mean = ({parts}) => parts.reduce((sum, {score}) => sum + Number(score), 0) / parts.length;
  return [...cases].sort((a, b) => mean(b) - mean(a));
}

const lineColour = colour => (isDark() ? onDark(colour) : colour);

/** The bands of the highest policies; null for all others, and for the optimum. */
function bandsOf(cases) {
  const highest = cases.filter(({policy}) => policy !== OPTIMAL).slice(0, MOST_BANDS);
  return cases.map(entry => (highest.includes(entry) ? bandOf(entry.parts) : null));
}

/** The interval of a case by part of the run; null if it has none. */
const bandOf = parts =>
  parts[0].low === ''
    ? null
    : {
        low: parts.map(({low}) => Number(low)),
        high: parts.map(({high}) => Number(high)),
      };

function drawBands({ctx, data: [x], series, valToPos}, bands) {
  ctx.save();
  ctx.globalAlpha = 0.15;
  bands.forEach((band, i) => {
    if (!band || !series[i + 1].show) return;
    const addPoint = (value, j) =>
      ctx.lineTo(valToPos(x[j], 'x', true), valToPos(value, 'y', true));
    ctx.fillStyle = series[i + 1].stroke();
    ctx.beginPath();
    band.high.forEach(addPoint);
    for (let j = band.low.length - 1; j >= 0; j--) addPoint(band.low[j], j);
    ctx.fill();
  });
  ctx.restore();
}

/**
 * The horizontal lines of yardsticks without a curve, at the mean score of a step over the seeds.
 */
function yardstickLines(yardsticks, settings, {scenario, detection}) {
  if (!yardsticks || !settings) return [];
  const rows = rowsOf(yardsticks).filter(
    row => row.scenario === scenario && row.detection === detection && row.yardstick !== OPTIMAL,
  );
  const steps = settings.find(entry => entry.scenario === scenario)?.steps;
  return distinct(rows, 'yardstick').map(name => {
    const own = rows.filter(row => row.yardstick === name);
    const bounds = meanScore(own.filter(row => row.is === 'at most')) / steps;
    const reached = meanScore(own.filter(row => row.is !== 'at most')) / steps;
    return {name, score: Number.isNaN(bounds) ? reached : bounds, reached};
  });
}

const meanScore = rows => rows.reduce((sum, row) => sum + Number(row.score), 0) / rows.length;

/** Draws the lines of yardsticks with names at their ends, moved down where they would overlap. */
function nameYardsticks({ctx, data, bbox, series, valToPos}, shown, lines) {
  ctx.save();
  ctx.font = `${0.8 * rem() * devicePixelRatio}px sans-serif`;
  ctx.textBaseline = 'middle';
  ctx.textAlign = 'left';
  ctx.fillStyle = ctx.strokeStyle = style('--ink');
  const curves = shown.flatMap(({policy}, i) =>
    policy === OPTIMAL && series[i + 1].show && data[i + 1].at(-1) != null
      ? [{name: policy, score: data[i + 1].at(-1)}]
      : [],
  );
  let last = -Infinity;
  for (const {name, score, reached} of [...curves, ...lines].sort((a, b) => b.score - a.score)) {
    const y = valToPos(score, 'y', true);
    if (reached !== undefined) {
      ctx.strokeRect(bbox.left, y, bbox.width, 0);
      if (reached < score) {
        ctx.globalAlpha = 0.15; // the interval between a plan and a bound
        ctx.fillRect(bbox.left, y, bbox.width, valToPos(reached, 'y', true) - y);
        ctx.globalAlpha = 1;
      }
    }
    last = Math.max(y, last + rem() * devicePixelRatio);
    ctx.fillText(name, bbox.left + bbox.width + 5, last);
  }
  ctx.restore();
}

const axis = more => ({
  stroke: () => style('--faint'),
  font: font(),
  labelSize: 1.4 * rem(),
  labelFont: font(),
  grid: {stroke: () => style('--grid'), width: 1},
  ticks: {stroke: () => style('--grid'), width: 1, size: 4},
  ...more,
});

const font = () => `${0.8 * rem()}px sans-serif`;
