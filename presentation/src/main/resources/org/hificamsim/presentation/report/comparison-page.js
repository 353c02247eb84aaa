// The page of a comparison: cases side by side with their intervals, the score over time, all runs, pictures and settings.
import {el, onThemeChange, rem, style} from './dom.js';
import {inflate} from './inflate.js';
import {rowsOf, sortable} from './table.js';
import {besideUnit, held, isShare, scoreNumber, spelled, tipped, told, words} from './names.js';
import {decimals, percent} from './numbers.js';
import {Readers} from './readers.js';

/** The metrics that a comparison begins with: the first one that is not 0 or missing everywhere. */
const FAVOURITES = [
  'proportion_of_optimal',
  'proportion_of_bound',
  'performance',
  'covered_k',
  'mean_k',
  'covered_1',
  'covered_0',
];
const SHORT = 4;
const OPTIMAL = 'optimal';

/** The page; `data` is what ComparisonReport wrote. */
export async function comparisonPage(root, data) {
  const adapting = data.tables.find(table => table.name === 'adapting.csv');
  const table = data.summary && comparison(data);
  const course = data.levels?.rows.length && curves(data);
  const tables = data.tables.map(table => card(titleOf(table.name), plainTable(table, data.names)));
  const figures = data.pictures.length && (await pictures(data.pictures));
  const made = [
    data.results &&
      folded(`All runs (${data.results.count})`, () => plainTable(data.results, data.names)),
    data.settings && settings(data.settings),
    card(
      'Made with',
      el('pre', {tabindex: 0}, data.command),
      el('p', {class: 'note'}, `HiFi-CamSim ${data.version}`),
    ),
  ];
  const ladder = kind(data) === 'Ladder';
  const readers = new Readers({
    planner: ladder
      ? [figures, ...tables, table, course, ...made]
      : [table, figures, ...tables, course, ...made],
    researcher: ladder
      ? [...tables, figures, course, table, ...made]
      : [course, table, ...tables, figures, ...made],
  });
  root.append(
    el('header', {}, el('h1', {}, kind(data), el('small', {}, data.title)), readers.control),
  );
  if (adapting) root.append(el('p', {class: 'notice'}, worthOfAdapting(rowsOf(adapting))));
  if (kind(data) === 'Comparison') root.append(...answers(data));
  if (ladder)
    root.append(...realism(rowsOf(data.tables.find(table => table.name === 'rungs.csv'))));
  root.append(...[badges(data), readers.element].filter(Boolean));
  root.dataset.ready = '';
}

const card = (title, ...children) =>
  el('section', {class: 'card'}, el('h2', {}, title), ...children);
const TITLES = {
  'choices.csv': 'What each detection model’s choice of policy achieves',
  'aggregate.csv': 'All scenarios together',
  'improvement.csv': 'Probability that one policy beats another',
  'pairs.csv': 'Differences between policies, paired by seed',
  'rungs.csv': 'What is lost where each rung chooses the policy',
  'ladder.csv': 'What each rung predicts of the policies',
  'ladder.svg': 'Each scenario',
  'cost.svg': 'All scenarios, and what a step costs',
};
const titleOf = name => TITLES[name] ?? name.replace(/\.(csv|svg)$/, '').replace(/[_-]/g, ' ');
const distinct = (rows, name) => [...new Set(rows.map(row => row[name]))];

function kind({tables}) {
  const has = name => tables.some(table => table.name === name);
  if (has('rungs.csv')) return 'Ladder';
  return has('sensitivity.csv')
    ? 'Sensitivity'
    : has('table-8.1.csv')
      ? 'Reproduction'
      : 'Comparison';
}

const ANSWERS = 4;

/** For each of the first scenarios the best score that a policy of a network reached under the last detection, in the objective's words. */
function answers({summary, settings}) {
  if (!summary || !settings?.[0]?.score_words) return [];
  const scores = rowsOf(summary).filter(({metric, mean}) => metric === 'score' && mean !== '');
  return distinct(scores, 'scenario')
    .slice(0, ANSWERS)
    .flatMap(scenario => {
      const of = scores.filter(
        row =>
          row.scenario === scenario &&
          row.detection === scores.findLast(one => one.scenario === scenario).detection &&
          !YARDSTICKS.includes(row.policy),
      );
      return of.length
        ? [
            answer(
              of.reduce((best, row) => (Number(row.mean) > Number(best.mean) ? row : best)),
              of,
              settings,
            ),
          ]
        : [];
    });
}

function answer(best, cases, settings) {
  const {
    steps,
    score_words: title,
    score_unit: unit,
    objective,
  } = settings.find(({scenario}) => scenario === best.scenario);
  const number = sum => scoreNumber(Number(sum) / steps, {share: unit === 'share'});
  best = {...best, ...held('score', '', best)};
  const interval =
    best.low !== best.high ? ` (95 % interval ${number(best.low)} to ${number(best.high)})` : '';
  return el(
    'p',
    {class: 'answer'},
    el('b', {}, number(best.mean)),
    ' ',
    tipped(title, objective),
    ` in ${best.scenario}: `,
    tipped(spelled(best.policy), best.policy),
    `${cases.length > 1 ? `, the best of ${cases.length} policies` : ''}, ${spelled(best.detection)}, the mean of ${steps} steps${interval}`,
  );
}

/** How much of the score is lost by leaving out realism: most on any rung, and the first rung whose choice loses next to nothing. */
function realism(rows) {
  const all = rows.filter(({scenario, share}) => scenario === 'all' && share !== '');
  if (!all.length) return [];
  const worst = all.reduce((most, row) => (Number(row.share) > Number(most.share) ? row : most));
  const enough = all.find(({share}) => Number(share) < ENOUGH);
  return [
    el(
      'p',
      {class: 'answer'},
      el('b', {}, percent(Number(worst.share))),
      ` of the best policy’s score is lost at most, where ${spelled(worst.rung)} chooses the policy`,
      enough
        ? `; ${spelled(enough.rung)} is the simplest rung that loses less than ${percent(ENOUGH)}`
        : '',
      `, judged by ${spelled(all.at(-1).rung)}, the mean of the scenarios`,
    ),
  ];
}

const ENOUGH = 0.01;

/** What a reader has to know before any proportion of the optimum. */
function worthOfAdapting(rows) {
  const same = rows.filter(row => row.same_every_step === 'true').length;
  const most = Math.max(...rows.map(row => Number(row.value_of_adapting)));
  return (
    `The optimum is static: one zoom for all cameras, never changed, has its k_min at every step in ${same} of ${rows.length} cases; ` +
    `at best, adapting the zoom is worth ${most.toFixed(2)} of a fixed one.`
  );
}

function badges({summary, settings}) {
  if (!summary) return null;
  const rows = rowsOf(summary);
  const count = (name, word) =>
    `${distinct(rows, name).length} ${word}${distinct(rows, name).length === 1 ? '' : 's'}`;
  const facts = [
    count('scenario', 'scenario'),
    count('detection', 'detection model'),
    `${distinct(rows, 'policy').length} policies`,
    `${Math.max(...rows.map(row => Number(row.runs)))} seeds`,
    settings && `${settings[0].steps} steps`,
  ];
  return el('p', {class: 'badges'}, ...facts.filter(Boolean).map(fact => el('span', {}, fact)));
}

/** The cases of one metric, each with its interval drawn to one scale. */
function comparison({summary, settings, colours, names}) {
  const rows = rowsOf(summary).map(row => ({
    ...row,
    ...held(row.metric, names[row.metric]?.unit, row),
  }));
  const metrics = distinct(rows, 'metric');
  const asked = settings?.some(({objective}) => objective !== 'kmin')
    ? ['score', ...FAVOURITES]
    : FAVOURITES;
  const pick = choice(
    'metric',
    metrics,
    asked.find(name => tells(rows, name)) || metrics[0],
    () => fill(),
    name => names[name]?.title ?? words(name),
  );
  const scenarios = choice('scenario', ['all', ...distinct(rows, 'scenario')], 'all', () => fill());
  const place = el('div', {class: 'scroll'});

  function fill() {
    const found = rows.filter(
      row =>
        row.metric === pick.value &&
        (scenarios.value === 'all' || row.scenario === scenarios.value),
    );
    const plans =
      pick.value === 'score' && settings?.[0]?.score_words
        ? distinct(found, 'scenario').map(name => settings.find(({scenario}) => scenario === name))
        : [];
    const shown = plans.length
      ? found.map(row => perStep(row, plans.find(({scenario}) => scenario === row.scenario).steps))
      : found;
    const {title, unit, meaning} = plans.length
      ? {
          ...names.score,
          title: `score, mean of the steps: ${distinct(plans, 'score_words').join('; ')}`,
          unit: plans.every(one => one.score_unit === 'share') ? 'share' : '',
        }
      : (names[pick.value] ?? {title: pick.value, unit: ''});
    place.replaceChildren(
      sortable(
        `${title}${unit ? ` (${isShare(unit) ? `% ${besideUnit(unit)}`.trim() : unit})` : ''}: mean and 95 % interval over seeds`,
        summaryColumns(shown, colours, unit),
        shown,
      ),
    );
    place.title = `${pick.value}: ${meaning ?? ''}`;
  }

  fill();
  return card(
    'Side by side',
    el('p', {class: 'pick'}, pick.label, scenarios.label),
    asked === FAVOURITES ? blank(rows, pick.value, names) : null,
    shortened(summary),
    place,
  );
}

/** The figures of a score, which is a sum, for one step. */
const perStep = (row, steps) =>
  Object.fromEntries(
    Object.entries(row).map(([name, text]) => [
      name,
      FIGURES.test(name) && text !== '' ? String(Number(text) / steps) : text,
    ]),
  );
const FIGURES = /^(mean|low|high|difference(_low|_high)?)$/;

/** Whether some case has another value than 0. */
const tells = (rows, metric) => rows.some(row => row.metric === metric && Number(row.mean) !== 0);

/** Says why the first metric is another one, where k_min is 0 throughout. */
function blank(rows, chosen, names) {
  if (!rows.some(row => row.metric === 'performance') || tells(rows, 'performance')) return null;
  return el(
    'p',
    {class: 'notice'},
    'All k_min are 0: at every step of every run there was a target that no camera covered. ' +
      `Performance is 0 and a proportion of the optimum is not defined, so the table begins with ${names[chosen].title}.`,
  );
}

function summaryColumns(rows, colours, unit) {
  const numbers = rows
    .flatMap(row => [row.mean, row.low, row.high])
    .filter(text => text !== '')
    .map(Number);
  const scale = [Math.min(0, ...numbers), Math.max(...numbers, 1e-12)];
  const digits = Math.max(
    0,
    Math.min(SHORT, SHORT - Math.floor(Math.log10(Math.max(...numbers.map(Math.abs), 1)))),
  );
  const short = text =>
    text === ''
      ? ''
      : isShare(unit)
        ? `${(100 * Number(text)).toFixed(digits - 2)} %`
        : Number(text).toFixed(digits);
  const columns = [
    {name: 'scenario'},
    {name: 'detection', show: spelled},
    {name: 'policy', show: spelled},
    {name: 'runs'},
    {name: 'mean', show: short},
    {name: 'low', show: short},
    {name: 'high', show: short},
    {
      name: 'mean',
      label: 'interval',
      show: (text, row) => whisker(row, scale, colours[row.policy]),
    },
  ];
  if (rows.some(row => row.difference)) {
    columns.push(
      {
        name: 'difference',
        label: `less ${distinct(
          rows.filter(row => row.difference_to),
          'difference_to',
        )
          .map(spelled)
          .join(', ')}`,
        show: short,
      },
      {name: 'difference_low', label: 'low', show: short},
      {name: 'difference_high', label: 'high', show: short},
    );
  }
  return columns.filter(column => rows.some(row => row[column.name] !== undefined));
}

/** A mean as a dot with its interval as a bar. */
function whisker({mean, low, high}, [least, most], colour) {
  if (mean === '') return '';
  const at = text => (100 * (Number(text) - least)) / (most - least);
  const svg = svgElement('svg', {
    viewBox: '-3 0 106 12',
    class: 'whisker',
    preserveAspectRatio: 'none',
    'aria-hidden': 'true',
  });
  svg.append(svgElement('line', {x1: 0, x2: 100, y1: 6, y2: 6, class: 'rail'}));
  if (low !== '')
    svg.append(
      svgElement('rect', {
        x: at(low),
        width: Math.max(0.4, at(high) - at(low)),
        y: 3.5,
        height: 5,
        fill: colour,
        opacity: 0.45,
      }),
    );
  svg.append(svgElement('rect', {x: at(mean) - 0.6, width: 1.2, y: 1, height: 10, fill: colour}));
  return svg;
}

function svgElement(tag, attributes) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  Object.entries(attributes).forEach(([name, value]) => element.setAttribute(name, value));
  return element;
}

function choice(name, values, chosen, onchange, nameOf = value => value) {
  const select = el(
    'select',
    {onchange, 'aria-label': name},
    ...values.map(value => el('option', {value, title: value}, nameOf(value))),
  );
  select.value = chosen;
  select.label = el('label', {}, `${name} `, select);
  return select;
}

/** What tells detection models apart: the lines, and their pieces in the legend. */
const DASHES = [
  {line: [], piece: 'solid'},
  {line: [8, 4], piece: 'dashed'},
  {line: [2, 4], piece: 'dotted'},
  {line: [10, 3, 2, 3], piece: 'double'},
];

/** The score over time of a scenario's cases: policies by colour, detection models by dashes, intervals as bands, yardsticks named at their ends. */
function curves({levels, colours, settings, yardsticks}) {
  const cases = casesOf(rowsOf(levels));
  const pick = choice('scenario', distinct(cases, 'scenario'), cases[0].scenario, () => draw());
  const box = el('div', {
    class: 'lines',
    role: 'img',
    'aria-label': 'score over time by case; the tables have the numbers',
  });
  const detections = distinct(cases, 'detection');
  const banded = cases.some(({parts}) => parts[0].low !== '');
  let plot;

  function draw() {
    const shown = cases.filter(one => one.scenario === pick.value);
    const x = shown[0].parts.map(part => Number(part.step));
    const {score_words: title, score_unit: unit} =
      settings?.find(({scenario}) => scenario === pick.value) ?? {};
    const share = unit === 'share';
    const bands = shown.map(({parts}) =>
      parts[0].low === ''
        ? null
        : {
            low: parts.map(part => Math.max(0, Number(part.low))),
            high: parts.map(part => Number(part.high)),
          },
    );
    const levelled = horizontal(yardsticks, settings, shown, detections);
    const most = Math.max(
      ...bands.flatMap(band => band?.high ?? []),
      ...levelled.map(({level}) => level),
    );
    plot?.destroy();
    plot = new uPlot(
      {
        width: box.clientWidth || 600,
        height: 26 * rem(),
        padding: [
          8,
          (levelled.length || shown.some(({policy}) => policy === OPTIMAL) ? 5.5 : 1) * rem(),
          0,
          0,
        ],
        cursor: {drag: {x: true, y: false}},
        scales: {
          x: {time: false},
          y: {
            range: (any, low, high) => [
              0,
              share
                ? Math.min(1, 1.05 * Math.max(high, most) || 1)
                : 1.05 * Math.max(high, most) || 1,
            ],
          },
        },
        axes: [
          axis({
            size: 2.2 * rem(),
            space: 5 * rem(),
            label: 'step',
            labelSize: 1.4 * rem(),
            labelFont: font(),
          }),
          axis({
            size: 3.5 * rem(),
            space: 2 * rem(),
            label: title ?? 'k_min (cameras)',
            labelSize: 1.4 * rem(),
            labelFont: font(),
            values: (any, ticks) => ticks.map(tick => (share ? percent(tick) : tick)),
          }),
        ],
        hooks: {
          drawAxes: [plot => drawBands(plot, bands)],
          draw: [plot => nameYardsticks(plot, shown, levelled)],
        },
        series: [{label: 'step'}, ...shown.map(one => series(one, share))],
        legend: {
          markers: {
            dash: (any, i) =>
              DASHES[Math.max(0, detections.indexOf(shown[i - 1]?.detection)) % DASHES.length]
                .piece,
          },
        },
      },
      [x, ...shown.map(one => one.parts.map(part => Number(part.score)))],
      box,
    );
  }

  const series = ({policy, detection}, share) => ({
    label: `${spelled(policy)}; ${spelled(detection)}`,
    stroke: policy === OPTIMAL ? () => style('--ink') : colours[policy],
    width: 0.12 * rem(),
    dash: DASHES[detections.indexOf(detection) % DASHES.length].line,
    points: {show: false},
    value: (any, value) => (value == null ? '' : share ? percent(value) : decimals(value, SHORT)),
  });
  new ResizeObserver(() =>
    requestAnimationFrame(() => {
      if (!plot) draw();
      else if (box.clientWidth) plot.setSize({width: box.clientWidth, height: 26 * rem()});
    }),
  ).observe(box);
  onThemeChange(() => plot?.redraw());
  const note =
    'Mean over the seeds' +
    (banded ? ', with its 95 % interval as a band' : '') +
    '; a point is one of fifty equal parts of the run, or a step where there are fewer. Hover for numbers, click names to hide lines, drag to look closer, double-click for all.';
  return card(
    'Score over time',
    el('p', {class: 'pick'}, pick.label),
    box,
    el('p', {class: 'note'}, note),
  );
}

/** What no policy of a network can run, and the others are measured by. */
const YARDSTICKS = [OPTIMAL, 'best-fixed', 'bound'];

const sameCase = (row, one) =>
  row.scenario === one.scenario && row.detection === one.detection && row.policy === one.policy;

/** The rows of each case, which follow each other. */
function casesOf(rows) {
  const cases = [];
  for (const row of rows) {
    if (!cases.length || !sameCase(row, cases[cases.length - 1]))
      cases.push({scenario: row.scenario, detection: row.detection, policy: row.policy, parts: []});
    cases[cases.length - 1].parts.push(row);
  }
  return cases;
}

function drawBands({ctx, data: [x], series, valToPos}, bands) {
  ctx.save();
  ctx.globalAlpha = 0.15;
  bands.forEach((band, i) => {
    if (!band || !series[i + 1].show) return;
    const at = (value, j) => ctx.lineTo(valToPos(x[j], 'x', true), valToPos(value, 'y', true));
    ctx.fillStyle = series[i + 1].stroke();
    ctx.beginPath();
    band.high.forEach(at);
    for (let j = band.low.length - 1; j >= 0; j--) at(band.low[j], j);
    ctx.fill();
  });
  ctx.restore();
}

/** The yardsticks without a curve: what each came to per step, the mean over the seeds. */
function horizontal(yardsticks, settings, shown, detections) {
  const rows =
    yardsticks && settings
      ? rowsOf(yardsticks).filter(
          row => row.scenario === shown[0].scenario && row.yardstick !== OPTIMAL,
        )
      : [];
  const {steps} = settings?.find(({scenario}) => scenario === shown[0].scenario) ?? {};
  return distinct(rows, 'yardstick').flatMap(name =>
    distinct(rows, 'detection').map(detection => {
      const scores = rows
        .filter(row => row.yardstick === name && row.detection === detection)
        .map(row => Number(row.score) / steps);
      return {
        name,
        level: scores.reduce((sum, score) => sum + score, 0) / scores.length,
        dash: DASHES[detections.indexOf(detection) % DASHES.length].line,
      };
    }),
  );
}

/** Names lines at their ends, each below the one before where they would meet. */
function nameYardsticks({ctx, data, bbox, series, valToPos}, shown, levelled) {
  ctx.save();
  ctx.font = `${0.8 * rem() * devicePixelRatio}px sans-serif`;
  ctx.textBaseline = 'middle';
  ctx.textAlign = 'left';
  ctx.fillStyle = ctx.strokeStyle = style('--ink');
  const curved = shown.flatMap(({policy}, i) =>
    policy === OPTIMAL && series[i + 1].show && data[i + 1].at(-1) != null
      ? [{name: policy, level: data[i + 1].at(-1)}]
      : [],
  );
  let last = -Infinity;
  for (const {name, level, dash} of [...curved, ...levelled].sort((a, b) => b.level - a.level)) {
    const y = valToPos(level, 'y', true);
    if (dash) {
      ctx.setLineDash(dash.length ? dash : [1, 0]);
      ctx.strokeRect(bbox.left, y, bbox.width, 0);
    }
    ctx.fillText(
      name,
      bbox.left + bbox.width + 5,
      (last = Math.max(y, last + rem() * devicePixelRatio)),
    );
  }
  ctx.restore();
}

const font = () => `${0.8 * rem()}px sans-serif`;
const axis = more => ({
  stroke: () => style('--faint'),
  font: font(),
  grid: {stroke: () => style('--grid'), width: 1},
  ticks: {stroke: () => style('--grid'), width: 1, size: 4},
  ...more,
});

/** Columns that hold options as they are written. */
const SPELLED = /detection|policy|objective|difference_to|^(better|worse|other|rung)$/;

/** Of the ladder: its scores are those of each scenario's objective. */
const LABELS = {
  mean_k_min: 'mean score of a step',
  regret: 'score lost',
  regret_low: 'low',
  regret_high: 'high',
  share: 'of the best',
  share_low: 'low',
  share_high: 'high',
  tau_low: 'low',
  tau_high: 'high',
};

const STATISTICS = {iqm: 'interquartile mean', optimality_gap: 'optimality gap'};

function plainTable(table, names = {}) {
  const columns = table.columns.map(name => ({
    name,
    label: LABELS[name] ?? names[name]?.title ?? words(name),
    title: name,
    show: text =>
      /^share(_|$)/.test(name) && text !== ''
        ? percent(Number(text))
        : SPELLED.test(name)
          ? spelled(text)
          : /^-?\d+\.(\d{5,}|\d+E-\d+)$/.test(text)
            ? decimals(Number(text), SHORT)
            : (names[text]?.title ?? STATISTICS[text] ?? text),
  }));
  return el(
    'div',
    {class: 'scroll'},
    shortened(table),
    sortable(titleOf(table.name), columns, rowsOf(table), 'unseen'),
  );
}

/** What is said of a table that is not here as a whole. */
function shortened({rows, count, name}) {
  return rows.length < count
    ? el('p', {class: 'notice'}, `The first ${rows.length} of ${count} rows; ${name} has all.`)
    : null;
}

/** A part that is made when it is opened. */
function folded(title, make) {
  const details = el(
    'details',
    {class: 'card', ontoggle: () => details.childElementCount === 1 && details.append(make())},
    el('summary', {}, title),
  );
  return details;
}

const WIDE = 800; // points: what would be too small to read next to another picture

async function pictures(list) {
  const figures = await Promise.all(
    list.map(async ({name, data}) => {
      if (!data)
        return el('p', {class: 'note'}, `${name} is left out, so that this file stays small.`);
      const address = URL.createObjectURL(new Blob([await inflate(data)], {type: 'image/svg+xml'}));
      return el(
        'figure',
        {},
        el('img', {
          src: address,
          alt: titleOf(name),
          onload: ({target}) =>
            target.parentElement.classList.toggle('wide', target.naturalWidth > WIDE),
        }),
        el('figcaption', {title: name}, titleOf(name)),
      );
    }),
  );
  return card('Pictures', el('div', {class: 'pictures'}, ...figures));
}

/** What is the same for all cases once, the rest in a table. */
function settings(list) {
  const text = told;
  const names = [...new Set(list.flatMap(Object.keys))];
  const differ = names.filter(name => new Set(list.map(one => text(one[name]))).size > 1);
  const same = names.filter(name => !differ.includes(name));
  const rows = list.map(one => Object.fromEntries(differ.map(name => [name, text(one[name])])));
  return card(
    'Settings',
    el(
      'p',
      {},
      ...same.map(name =>
        el(
          'span',
          {class: 'setting', title: name},
          `${words(name)}: `,
          el('b', {}, text(list[0][name])),
        ),
      ),
    ),
    el(
      'div',
      {class: 'scroll'},
      sortable(
        'settings.json',
        differ.map(name => ({
          name,
          label: words(name),
          title: name,
          show: text => (SPELLED.test(name) ? spelled(text) : text),
        })),
        rows,
      ),
    ),
  );
}
