// The cards of a comparison's tables, pictures and settings, as its files have them.
import {card} from './cards.js';
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
  'ladder.svg': 'Each scenario',
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
const FRACTION = /^-?\d+\.\d+(E-\d+)?$/;
const SIGNIFICANCE = 0.05;

/**
 * The colours of paper, ink and grid in pictures, each with the one that replaces it on dark pages.
 */
const DARK_COLOURS = [
  ['white', '#1a222b'],
  ['rgb(34,34,34)', '#e8edf2'],
  ['rgb(85,85,85)', '#b4bfca'],
  ['rgb(119,119,119)', '#8b98a5'],
  ['rgb(227,227,227)', '#34404c'],
];
const DARK_RULES = ['fill', 'stroke']
  .flatMap(part =>
    DARK_COLOURS.map(
      ([light, dark]) => `[style*="${part}:${light}"] { ${part}: ${dark} !important; }`,
    ),
  )
  .join(' ');
const DARK_STYLE = `<style>@media (prefers-color-scheme: dark) { ${DARK_RULES} }</style>`;
const WIDE_PICTURE = 800; // points; wider ones get a row of their own, to be readable

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
  const seeds = Math.max(...rows.map(row => Number(row[columns.indexOf('runs')])));
  const least = Math.floor(Math.log2(count / SIGNIFICANCE)) + 2;
  if (!rows.length || seeds >= least) return null;
  return el(
    'p',
    {class: 'notice'},
    `With ${seeds} seeds none of ${count} differences can have a corrected p below ` +
      `${SIGNIFICANCE}: take ${least} seeds, or compare fewer policies. The intervals hold.`,
  );
}

/** A notice that a table shows only the first rows of its file; null if it shows all. */
export const cutNotice = ({rows, count, name}) =>
  rows.length < count
    ? el('p', {class: 'notice'}, `The first ${rows.length} of ${count} rows; ${name} has all.`)
    : null;

/** The card of a comparison's pictures, with a note for each that was too large for the page. */
export async function pictureCard(pictures) {
  const figures = await Promise.all(pictures.map(picture));
  return card('Pictures', el('div', {class: 'pictures'}, ...figures));
}

async function picture({name, data}) {
  if (!data) return el('p', {class: 'note'}, `${name} is left out to keep this file small.`);
  const drawn = new TextDecoder().decode(await inflate(data));
  const image = new Blob([drawn.replace(/<\/svg\s*>\s*$/, `${DARK_STYLE}</svg>`)], {
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

/** The card of settings: once those that all cases share, in a table those that differ. */
export function settingsCard(cases) {
  const names = [...new Set(cases.flatMap(settingNames))];
  const isSame = name => new Set(cases.map(settings => settingOf(settings, name))).size === 1;
  const different = names.filter(name => !isSame(name));
  const columns = different.map(name => ({
    name,
    label: settingName(name),
    title: name,
  }));
  const rows = cases.map(settings =>
    Object.fromEntries(different.map(name => [name, settingOf(settings, name)])),
  );
  const same = names.filter(isSame).map(name => {
    const value = el('b', {}, settingOf(cases[0], name));
    return el('span', {class: 'setting', title: name}, `${settingName(name)}: `, value);
  });
  return card(
    'Settings',
    el('p', {}, ...same),
    el('div', {class: 'scroll'}, sortable('settings.json', columns, rows)),
  );
}
