// The cards of a comparison's tables, pictures and settings, as its files have them.
import {card} from './cards.js';
import {onDark, rgb} from './contrast.js';
import {el} from './dom.js';
import {inflate} from './inflate.js';
import {settingName, settingNames, settingOf, spelled, words} from './names.js';
import {decimals, percent, tableNumber} from './numbers.js';
import {rowsOf, sortable} from './table.js';

const TITLES = {
  'choices.csv': 'What each detection model’s choice of policy achieves',
  'aggregate.csv': 'Aggregates over all runs',
  'improvement.csv': 'Probability that one policy beats another',
  'pairs.csv': 'Differences between policies, paired by seed',
  'rungs.csv': 'What is lost where each rung chooses the policy',
  'ladder.csv': 'What each rung predicts of the policies',
  'ladder.svg': 'How far each rung can be trusted in each scenario',
  'coverage.svg': 'How many cameras cover the targets, by policy',
  'proportion.svg': 'The score of each policy as a share of the yardstick',
  'profile.svg': 'How many runs reach which share of the yardstick',
  'cost.svg': 'How far each rung can be trusted over all scenarios, and what a step costs',
};

/**
 * The labels of columns, mainly a ladder's, whose scores are those of each scenario's objective.
 */
const LABELS = {
  judge: 'judged by',
  mean_k_min: 'mean score of a step',
  regret: 'score lost',
  regret_low: 'low',
  regret_high: 'high',
  share: 'of the best',
  share_low: 'low',
  share_high: 'high',
  p_value: 'p',
  p_holm: 'p, corrected',
  tau_low: 'low',
  tau_high: 'high',
};
const STATISTICS = {iqm: 'interquartile mean', optimality_gap: 'optimality gap'};

const OVER_TIME = /^(k_min|score)-(.+)\.svg$/;
/** The columns whose texts are shown in words. */
const SPELLED = /detection|policy|objective|difference_to|^(better|worse|other|rung|judge|chosen)$/;
/** Separates policies that tie. */
const TIE = ' | ';
const SHARE = /^share(_|$)/;
const SCORE = /^(predicted|achieved)(_|$)/;
const WHOLE = /^seeds_needed$/;
const IN_ANSWERS = /^score_(words|unit)$/; // what the sentences at the top say
const FRACTION = /^-?\d+\.\d+(E-\d+)?$/;
const SIGNIFICANCE = 0.05;

/** Paper, ink and grid of pictures, and their colours on dark pages. */
const DARK_COLOURS = [
  ['white', '#1a222b'],
  ['rgb(34,34,34)', '#e8edf2'],
  ['rgb(85,85,85)', '#b4bfca'],
  ['rgb(119,119,119)', '#8b98a5'],
  ['rgb(227,227,227)', '#34404c'],
];
const WIDE_PICTURE = 800; // points; too small to be read next to another picture

/** The title of a table or picture by the name of its file. */
export const titleOf = name =>
  TITLES[name] ??
  OVER_TIME.exec(name)?.[2].replace(/^/, 'Each policy’s score over time in ') ??
  name.replace(/\.(csv|svg)$/, '').replace(/[_-]/g, ' ');

/**
 * Shows a table of a file, without rows that count no run.
 * @param details `names` with the titles of metrics, and `settings`, which say whose scores are
 *   shares
 */
export function fileTable(table, {names = {}, settings = []}) {
  const shares = (settings ?? []).filter(plan => plan.score_unit === 'share');
  const isShare = (column, {scenario}) =>
    SHARE.test(column) || (SCORE.test(column) && shares.some(plan => plan.scenario === scenario));
  const columns = table.columns.map(name => ({
    name,
    label: LABELS[name] ?? names[name]?.title ?? words(name),
    title: name,
    show: (text, row) =>
      isShare(name, row) && text !== '' ? percent(Number(text)) : cellText(name, text, names),
  }));
  return el(
    'div',
    {class: 'scroll'},
    cutNotice(table),
    table.name === 'pairs.csv' ? seedsNotice(table) : null,
    sortable(titleOf(table.name), columns, rowsOf(table).filter(hasRuns), 'unseen'),
  );
}

const hasRuns = ({runs, scenarios}) => runs !== '0' && scenarios !== '0';

function cellText(column, text, names) {
  if (SPELLED.test(column)) return text.split(TIE).map(spelled).join(' or ');
  if (WHOLE.test(column) && text !== '') return decimals(Number(text), 0);
  if (FRACTION.test(text)) return tableNumber(Number(text));
  return names[text]?.title ?? STATISTICS[text] ?? text;
}

/** A notice that no difference can pass Holm's correction with so few seeds; null if one can. */
function seedsNotice({rows, count, columns}) {
  const runs = rows.map(row => Number(row[columns.indexOf('runs')]));
  const tests = count - runs.filter(number => number < 2).length; // a single run has no p-value
  const seeds = Math.max(...runs);
  const least = Math.floor(Math.log2(tests / SIGNIFICANCE)) + 2;
  if (!rows.length || seeds >= least) return null;
  return el(
    'p',
    {class: 'notice'},
    `With ${seeds} seeds none of ${tests} differences can have a corrected p below ` +
      `${SIGNIFICANCE}: take ${least} seeds, or compare fewer policies. The intervals hold.`,
  );
}

/** A notice that a table shows only the first rows of its file; null if it shows all. */
export const cutNotice = ({rows, count, name}) =>
  rows.length < count
    ? el('p', {class: 'notice'}, `The first ${rows.length} of ${count} rows; ${name} has all.`)
    : null;

/** The pictures of a comparison, those that fit into the page, and the colours of policies. */
export async function pictureCard(pictures, colours = {}) {
  const style = darkStyle(Object.values(colours));
  const figures = await Promise.all(pictures.map(drawn => picture(drawn, style)));
  return card('Pictures', el('div', {class: 'pictures'}, ...figures));
}

/** A style of pictures on dark pages; policies keep their colours where these can be seen. */
function darkStyle(colours) {
  const pairs = [...colours.map(colour => [rgb(colour), onDark(colour)]), ...DARK_COLOURS];
  const rules = ['fill', 'stroke'].flatMap(part =>
    pairs.map(([light, dark]) => `[style*="${part}:${light}"] { ${part}: ${dark} !important; }`),
  );
  return `<style>@media (prefers-color-scheme: dark) { ${rules.join(' ')} }</style>`;
}

async function picture({name, data}, style) {
  if (!data) return el('p', {class: 'note'}, `${name} is left out, so that this file stays small.`);
  const drawn = new TextDecoder().decode(await inflate(data));
  const image = new Blob([drawn.replace(/<\/svg\s*>\s*$/, `${style}</svg>`)], {
    type: 'image/svg+xml',
  });
  const src = URL.createObjectURL(image);
  const figure = el(
    'figure',
    {},
    el(
      'a',
      {href: src, target: '_blank', title: 'opens the picture alone'},
      el('img', {
        src,
        alt: titleOf(name),
        onload: ({target}) => figure.classList.toggle('wide', target.naturalWidth > WIDE_PICTURE),
      }),
    ),
    el('figcaption', {title: name}, titleOf(name)),
  );
  return figure;
}

/**
 * The settings of all cases: those that are the same once, the others in a table, with a row for
 * all policies that have the same.
 */
export function settingsCard(cases) {
  const names = [...new Set(cases.flatMap(settingNames))].filter(name => !IN_ANSWERS.test(name));
  const isSame = name => new Set(cases.map(settings => settingOf(settings, name))).size === 1;
  const different = names.filter(name => !isSame(name));
  const rows = withPoliciesJoined(
    cases.map(settings =>
      Object.fromEntries(different.map(name => [name, settingOf(settings, name)])),
    ),
  );
  const columns = different
    .filter(name => new Set(rows.map(row => row[name])).size > 1)
    .map(name => ({name, label: settingName(name), title: name}));
  const same = names
    .filter(name => !columns.some(column => column.name === name))
    .map(name => {
      const value = el('b', {}, (different.length && rows[0][name]) || settingOf(cases[0], name));
      return el('span', {class: 'setting', title: name}, `${settingName(name)}: `, value);
    });
  return card(
    'Settings',
    el('p', {}, ...same),
    rows.length > 1
      ? el('div', {class: 'scroll'}, sortable('Settings that differ', columns, rows))
      : null,
  );
}

/** Joins the rows that differ in their policies alone. */
function withPoliciesJoined(rows) {
  const joined = new Map();
  for (const {policy, ...rest} of rows) {
    const key = JSON.stringify(rest);
    joined.set(key, [...(joined.get(key) ?? []), policy]);
  }
  return [...joined].map(([key, policies]) => ({...JSON.parse(key), policy: policies.join(', ')}));
}
