// The table that compares the cases by one metric, with intervals drawn to one scale.
import {card, labelledSelect, svg} from './cards.js';
import {cutNotice} from './comparison-tables.js';
import {onDark} from './contrast.js';
import {el} from './dom.js';
import {isShare, spelled, unitAfterPercent, words} from './names.js';
import {distinct, rowsOf, sortable} from './table.js';
import {OPTIMAL} from './yardsticks.js';

/** The metrics in order of preference: the first that is not 0 or missing everywhere is shown. */
const FAVOURITES = [
  'proportion_of_optimal',
  'proportion_of_bound',
  'proportion_of_reachable',
  'mean_score',
  'covered_k',
  'mean_k',
  'covered_1',
  'covered_0',
];
const DIGITS = 4;

export function sideBySide({summary, settings, colours, names}) {
  const rows = rowsOf(summary);
  const metrics = distinct(rows, 'metric');
  const hasObjective = settings?.some(({objective}) => objective !== 'kmin');
  const favourites = hasObjective ? ['mean_score', ...FAVOURITES] : FAVOURITES;
  const metric = labelledSelect(
    'metric',
    metrics,
    favourites.find(name => isInformative(rows, name)) || metrics[0],
    () => fill(),
    name => names[name]?.title ?? words(name),
  );
  const choose = (name, chosen) =>
    labelledSelect(
      name,
      distinct(rows, name).length > 1 ? ['all', ...distinct(rows, name)] : distinct(rows, name),
      chosen,
      () => fill(),
      spelled,
    );
  const scenario = choose(
    'scenario',
    distinct(rows, 'scenario').length > 1 ? 'all' : rows[0].scenario,
  );
  const detection = choose('detection', distinct(rows, 'detection').at(-1));
  const more = el('input', {type: 'checkbox', name: 'more-columns', onchange: () => fill()});
  const tableBox = el('div', {class: 'scroll'});

  function fill() {
    const isChosen = (row, select) => select.value === 'all' || row[select.name] === select.value;
    const shown = inOrder(
      rows.filter(
        row => row.metric === metric.value && isChosen(row, scenario) && isChosen(row, detection),
      ),
    );
    const inWords = metric.value === 'mean_score' && settings?.[0]?.score_words;
    const {title, unit, meaning, units} = inWords
      ? scoreInWords(distinct(shown, 'scenario'), settings, names)
      : (names[metric.value] ?? {title: metric.value, unit: ''});
    const shownUnit = isShare(unit) ? `% ${unitAfterPercent(unit)}`.trim() : unit;
    const caption = `${title}${unit ? ` (${shownUnit})` : ''}: mean and 95 % interval over seeds`;
    tableBox.replaceChildren(
      sortable(caption, caseColumns(shown, colours, units ?? unit, more.checked), shown),
    );
    tableBox.title = `${metric.value}: ${meaning ?? ''}`;
  }

  fill();
  return card(
    'Side by side',
    el(
      'p',
      {class: 'pick'},
      metric.label,
      scenario.label,
      detection.label,
      el('label', {}, more, ' all columns'),
    ),
    hasObjective ? null : allZeroNotice(rows, metric.value, names),
    cutNotice(summary),
    tableBox,
  );
}

/** Sorts the rows of each scenario and detection by their mean, the highest first. */
function inOrder(rows) {
  const groups = distinct(rows, 'scenario').flatMap(scenario =>
    distinct(rows, 'detection').map(detection =>
      rows.filter(row => row.scenario === scenario && row.detection === detection),
    ),
  );
  return groups.flatMap(group => group.sort((a, b) => Number(b.mean) - Number(a.mean)));
}

/** Describes the metric mean_score in the words of the objectives. */
function scoreInWords(scenarios, settings, names) {
  const plans = scenarios.map(name => settings.find(({scenario}) => scenario === name));
  return {
    ...names.mean_score,
    title: `score, mean of the steps: ${distinct(plans, 'score_words').join('; ')}`,
    unit: plans.every(plan => plan.score_unit === 'share') ? 'share' : '',
    units:
      distinct(plans, 'score_words').length > 1
        ? Object.fromEntries(plans.map(plan => [plan.scenario, plan.score_unit]))
        : null, // different objectives: each scenario has a scale of its own
  };
}

/** Whether a metric differs from 0 in at least one case. */
const isInformative = (rows, metric) =>
  rows.some(row => row.metric === metric && Number(row.mean) !== 0);

/** Explains why the table begins with another metric if k_min is 0 throughout; otherwise null. */
function allZeroNotice(rows, metric, names) {
  const hasKMin = rows.some(row => row.metric === 'performance');
  if (!hasKMin || isInformative(rows, 'performance')) return null;
  return el(
    'p',
    {class: 'notice'},
    'k_min is always 0: at every step of every run there was a target that no camera covered. ' +
      'Its sum is 0 and a proportion of the optimum is not defined, ' +
      `so the table begins with ${names[metric].title}.`,
  );
}

/**
 * The columns of a table of cases: policy, mean, and the interval as a bar.
 * @param units the unit of all scenarios; or an object of units by scenario, each with its scale
 * @param all whether runs, limits of intervals and columns with one value are shown, too
 */
function caseColumns(rows, colours, units, all) {
  const unitOf = ({scenario}) => (typeof units === 'object' ? units[scenario] : units);
  const scales = new Map();
  const scaleOf = ({scenario}) => {
    const name = typeof units === 'object' ? scenario : '';
    if (!scales.has(name))
      scales.set(name, scale(name ? rows.filter(row => row.scenario === name) : rows));
    return scales.get(name);
  };
  const show = (text, row) =>
    numberText(Math.max(...scaleOf(row).map(Math.abs), 1), unitOf(row))(text);
  const differs = name => all || distinct(rows, name).length > 1;
  return [
    differs('scenario') && {name: 'scenario'},
    differs('detection') && {name: 'detection', show: spelled},
    {name: 'policy', show: spelled},
    all && {name: 'runs'},
    {name: 'mean', show},
    all && {name: 'low', show},
    all && {name: 'high', show},
    {
      name: 'mean',
      label: 'interval',
      show: (text, row) =>
        whisker(row, scaleOf(row), row.policy === OPTIMAL ? null : colours[row.policy]),
    },
    ...(all ? differenceColumns(rows, rows.length ? unitOf(rows[0]) : '', show) : []),
  ].filter(Boolean);
}

/** The least and the greatest number of rows, [least, greatest]; the range includes 0. */
function scale(rows) {
  const numbers = rows
    .flatMap(row => [row.mean, row.low, row.high])
    .filter(text => text !== '')
    .map(Number);
  return [Math.min(0, ...numbers), Math.max(...numbers, 1e-12)];
}

/** The columns of the difference to the first detection; of shares in percentage points. */
function differenceColumns(rows, unit, show) {
  const compared = distinct(
    rows.filter(row => row.difference_to),
    'difference_to',
  );
  if (!compared.length) return [];
  const points = text => (text === '' ? '' : (100 * Number(text)).toFixed(1));
  const number = isShare(unit) ? points : show;
  const reference = compared.map(spelled).join(', ');
  const name = `difference to ${reference}${isShare(unit) ? ', points' : ''}`;
  return [
    {name: 'difference', label: name, show: number},
    {name: 'difference_low', label: 'from', show: number},
    {name: 'difference_high', label: 'to', show: number},
  ];
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

/** A mean with its interval, as a mark and a bar; without a colour in that of the text. */
function whisker({mean, low, high}, [least, most], colour) {
  if (mean === '') return '';
  const positionOf = text => (100 * (Number(text) - least)) / (most - least);
  const drawing = svg('svg', {
    viewBox: '-3 0 106 12',
    class: 'whisker',
    preserveAspectRatio: 'none',
    'aria-hidden': 'true',
  });
  if (colour) {
    drawing.style.setProperty('--light', colour); // a style in the HTML would need a hash
    drawing.style.setProperty('--dark', onDark(colour));
  }
  drawing.append(svg('line', {x1: 0, x2: 100, y1: 6, y2: 6, class: 'rail'}));
  if (low !== '') {
    const width = Math.max(0.4, positionOf(high) - positionOf(low));
    drawing.append(svg('rect', {x: positionOf(low), width, y: 3.5, height: 5, opacity: 0.45}));
  }
  drawing.append(svg('rect', {x: positionOf(mean) - 0.6, width: 1.2, y: 1, height: 10}));
  return drawing;
}
