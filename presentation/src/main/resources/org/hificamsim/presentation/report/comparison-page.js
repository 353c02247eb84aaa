// Builds the page of a comparison: the findings, cases side by side, the score over time, tables.
import {card, foldedCard, madeWith} from './cards.js';
import {bestScores, worthOfAdapting, worthOfRealism} from './comparison-answers.js';
import {sideBySide} from './comparison-cases.js';
import {scoreOverTime} from './comparison-curves.js';
import {fileTable, pictureCard, settingsCard, titleOf} from './comparison-tables.js';
import {el} from './dom.js';
import {ladderMaps} from './ladder-map.js';
import {useLabels} from './names.js';
import {Readers} from './readers.js';
import {distinct, rowsOf} from './table.js';
import {YARDSTICKS} from './yardsticks.js';

/** Builds the page from data that ComparisonReport wrote. */
export async function comparisonPage(root, data) {
  useLabels(data.labels);
  const cases = data.summary && sideBySide(data);
  const curves = data.levels?.rows.length && scoreOverTime(data);
  const kind = kindOf(data);
  const tables =
    kind === 'Ladder' ? ladderCards(data) : data.tables.map(table => tableCard(table, data));
  const pictures = data.pictures.length && (await pictureCard(data.pictures, data.colours));
  const rest = [
    data.results &&
      foldedCard(`All runs (${data.results.count})`, () => fileTable(data.results, data)),
    data.settings && settingsCard(data.settings),
    madeWith(data),
  ];
  const readers = new Readers(
    kind === 'Ladder'
      ? {
          researcher: [...tables, pictures, cases, curves, ...rest],
          planner: [pictures, ...tables, cases, curves, ...rest],
        }
      : {
          researcher: [cases, curves, ...tables, pictures, ...rest],
          planner: [cases, pictures, ...tables, curves, ...rest],
        },
  );
  root.append(
    el('header', {}, el('h1', {}, kind, el('small', {}, data.title)), readers.control),
    ...answers(kind, data),
    ...[badges(data), readers.element].filter(Boolean),
  );
  root.dataset.ready = '';
}

const tableCard = (table, data) => card(titleOf(table.name), fileTable(table, data));

/** The cards of a ladder: heat maps of the policies' order, and the tables, those shown folded. */
function ladderCards(data) {
  const maps = ['ladder.csv', 'rungs.csv'].map(name => tableOf(data, name));
  return [
    ladderMaps(...maps),
    ...data.tables.map(table =>
      maps.includes(table)
        ? foldedCard(titleOf(table.name), () => fileTable(table, data))
        : tableCard(table, data),
    ),
  ];
}

/** The kind of a comparison, which its tables tell. */
function kindOf(data) {
  if (tableOf(data, 'rungs.csv') && tableOf(data, 'ladder.csv')) return 'Ladder';
  if (tableOf(data, 'sensitivity.csv')) return 'Sensitivity';
  return tableOf(data, 'table-8.1.csv') ? 'Reproduction' : 'Comparison';
}

const tableOf = ({tables}, name) => tables.find(table => table.name === name);

/** The sentences at the top of the page. */
function answers(kind, data) {
  const adapting = tableOf(data, 'adapting.csv');
  return [
    ...(adapting ? [worthOfAdapting(rowsOf(adapting))] : []),
    ...(kind === 'Comparison' ? bestScores(data) : []),
    ...(kind === 'Ladder' ? worthOfRealism(rowsOf(tableOf(data, 'rungs.csv'))) : []),
  ];
}

/**
 * The numbers of scenarios, detection models, policies, seeds and steps; null without a summary.
 */
function badges({summary, settings}) {
  if (!summary) return null;
  const rows = rowsOf(summary);
  const counted = (length, one, many = `${one}s`) => `${length} ${length === 1 ? one : many}`;
  const count = (name, noun) => counted(distinct(rows, name).length, noun);
  const policies = distinct(rows, 'policy').filter(name => !YARDSTICKS.includes(name));
  const steps = distinct(settings ?? [], 'steps');
  const facts = [
    count('scenario', 'scenario'),
    count('detection', 'detection model'),
    counted(policies.length, 'policy', 'policies'),
    counted(Math.max(...rows.map(row => Number(row.runs))), 'seed'),
    steps.length === 1 && counted(steps[0], 'step'),
  ];
  return el('p', {class: 'badges'}, ...facts.filter(Boolean).map(fact => el('span', {}, fact)));
}
