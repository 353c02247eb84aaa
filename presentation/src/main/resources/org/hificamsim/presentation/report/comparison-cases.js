// The cases of a comparison side by side: a table of one metric, with intervals drawn to one scale.
import {card, labelledSelect, svg} from './cards.js';
import {cutNotice} from './comparison-tables.js';
import {el} from './dom.js';
import {isShare, limited, spelled, unitAfterPercent, words} from './names.js';
import {distinct, rowsOf, sortable} from './table.js';

/** The metrics of which the first one that is not 0 or missing everywhere is shown at first. */
const FAVOURITES = [
  'proportion_of_optimal',
  'proportion_of_bound',
  'proportion_of_reachable',
  'performance',
  'covered_k',
  'mean_k',
  'covered_1',
  'covered_0',
];
const DIGITS = 4;
const SUMS = /^(mean|low|high|difference(_low|_high)?)$/;

export function sideBySide({summary, settings, colours, names}) {
  const rows = rowsOf(summary).map(row => ({
    ...row,
    ...limited(row.metric, names[row.metric]?.unit, row),
  }));
  const metrics = distinct(rows, 'metric');
  const hasObjective = settings?.some(({objective}) => objective !== 'kmin');
  const favourites = hasObjective ? ['score', ...FAVOURITES] : FAVOURITES;
  const metric = labelledSelect(
    'metric',
    metrics,
    favourites.find(name => isInformative(rows, name)) || metrics[0],
    () => fill(),
    name => names[name]?.title ?? words(name),
  );
  const scenarios = ['all', ...distinct(rows, 'scenario')];
  const scenario = labelledSelect('scenario', scenarios, 'all', () => fill());
  const place = el('div', {class: 'scroll'});

  function fill() {
    const chosen = rows.filter(
      row =>
        row.metric === metric.value &&
        (scenario.value === 'all' || row.scenario === scenario.value),
    );
    const {shown, title, unit, meaning} =
      metric.value === 'score' && settings?.[0]?.score_words
        ? scorePerStep(chosen, settings, names)
        : {shown: chosen, ...(names[metric.value] ?? {title: metric.value, unit: ''})};
    const shownUnit = isShare(unit) ? `% ${unitAfterPercent(unit)}`.trim() : unit;
    const caption = `${title}${unit ? ` (${shownUnit})` : ''}: mean and 95 % interval over seeds`;
    place.replaceChildren(sortable(caption, caseColumns(shown, colours, unit), shown));
    place.title = `${metric.value}: ${meaning ?? ''}`;
  }

  fill();
  return card(
    'Side by side',
    el('p', {class: 'pick'}, metric.label, scenario.label),
    hasObjective ? null : allZeroNotice(rows, metric.value, names),
    cutNotice(summary),
    place,
  );
}

/** The rows of the score, which is a sum, as means of the steps, with the objectives' words. */
function scorePerStep(rows, settings, names) {
  const settingsOf = name => settings.find(({scenario}) => scenario === name);
  const plans = distinct(rows, 'scenario').map(settingsOf);
  return {
    shown: rows.map(row => perStep(row, settingsOf(row.scenario).steps)),
    ...names.score,
    title: `score, mean of the steps: ${distinct(plans, 'score_words').join('; ')}`,
    unit: plans.every(plan => plan.score_unit === 'share') ? 'share' : '',
  };
}

const perStep = (row, steps) =>
  Object.fromEntries(
    Object.entries(row).map(([name, text]) => [
      name,
      SUMS.test(name) && text !== '' ? String(Number(text) / steps) : text,
    ]),
  );

/** Whether a metric is not 0 in some case. */
const isInformative = (rows, metric) =>
  rows.some(row => row.metric === metric && Number(row.mean) !== 0);

/** Explains the first metric if k_min is 0 throughout; null if it is not. */
function allZeroNotice(rows, metric, names) {
  const hasKMin = rows.some(row => row.metric === 'performance');
  if (!hasKMin || isInformative(rows, 'performance')) return null;
  return el(
    'p',
    {class: 'notice'},
    'All k_min are 0: at every step of every run there was a target that no camera covered. ' +
      'Performance is 0 and a proportion of the optimum is not defined, ' +
      `so the table begins with ${names[metric].title}.`,
  );
}

function caseColumns(rows, colours, unit) {
  const numbers = rows
    .flatMap(row => [row.mean, row.low, row.high])
    .filter(text => text !== '')
    .map(Number);
  const scale = [Math.min(0, ...numbers), Math.max(...numbers, 1e-12)];
  const show = numberText(Math.max(...numbers.map(Math.abs), 1), unit);
  const columns = [
    {name: 'scenario'},
    {name: 'detection', show: spelled},
    {name: 'policy', show: spelled},
    {name: 'runs'},
    {name: 'mean', show},
    {name: 'low', show},
    {name: 'high', show},
    {
      name: 'mean',
      label: 'interval',
      show: (text, row) => whisker(row, scale, colours[row.policy]),
    },
  ];
  if (rows.some(row => row.difference)) {
    const compared = distinct(
      rows.filter(row => row.difference_to),
      'difference_to',
    );
    columns.push(
      {name: 'difference', label: `less ${compared.map(spelled).join(', ')}`, show},
      {name: 'difference_low', label: 'low', show},
      {name: 'difference_high', label: 'high', show},
    );
  }
  return columns.filter(column => rows.some(row => row[column.name] !== undefined));
}

/** Returns a function that shows numbers with as many decimals as the largest of them allows. */
function numberText(largest, unit) {
  const digits = Math.max(0, Math.min(DIGITS, DIGITS - Math.floor(Math.log10(largest))));
  return text => {
    if (text === '') return '';
    return isShare(unit)
      ? `${(100 * Number(text)).toFixed(digits - 2)} %`
      : Number(text).toFixed(digits);
  };
}

/** A mean with its interval, as a mark and a bar. */
function whisker({mean, low, high}, [least, most], colour) {
  if (mean === '') return '';
  const place = text => (100 * (Number(text) - least)) / (most - least);
  const drawing = svg('svg', {
    viewBox: '-3 0 106 12',
    class: 'whisker',
    preserveAspectRatio: 'none',
    'aria-hidden': 'true',
  });
  drawing.append(svg('line', {x1: 0, x2: 100, y1: 6, y2: 6, class: 'rail'}));
  if (low !== '') {
    const width = Math.max(0.4, place(high) - place(low));
    drawing.append(
      svg('rect', {x: place(low), width, y: 3.5, height: 5, fill: colour, opacity: 0.45}),
    );
  }
  drawing.append(svg('rect', {x: place(mean) - 0.6, width: 1.2, y: 1, height: 10, fill: colour}));
  return drawing;
}
