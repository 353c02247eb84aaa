// The sentences at the top of a comparison's page: what was found, in the objective's words.
import {el} from './dom.js';
import {limited, scoreNumber, spelled, tipped} from './names.js';
import {percent} from './numbers.js';
import {distinct, rowsOf} from './table.js';
import {YARDSTICKS} from './yardsticks.js';

const MOST_ANSWERS = 4;
const NEGLIGIBLE_LOSS = 0.01;

/**
 * For each of the first scenarios, a sentence with the best score of a deployable policy under the
 * last detection.
 */
export function bestScores({summary, settings}) {
  if (!summary || !settings?.[0]?.score_words) return [];
  const scores = rowsOf(summary).filter(({metric, mean}) => metric === 'score' && mean !== '');
  return distinct(scores, 'scenario')
    .slice(0, MOST_ANSWERS)
    .map(scenario => deployable(scores.filter(row => row.scenario === scenario)))
    .filter(cases => cases.length)
    .map(cases => bestScore(cases, settings));
}

const deployable = rows =>
  rows.filter(
    ({detection, policy}) => detection === rows.at(-1).detection && !YARDSTICKS.includes(policy),
  );

function bestScore(cases, settings) {
  const row = greatest(cases, 'mean');
  const best = {...row, ...limited('score', '', row)};
  const {
    steps,
    score_words: title,
    score_unit: unit,
    objective,
  } = settings.find(({scenario}) => scenario === best.scenario);
  const number = sum => scoreNumber(Number(sum) / steps, {share: unit === 'share'});
  const interval =
    best.low !== best.high ? ` (95 % interval ${number(best.low)} to ${number(best.high)})` : '';
  const choice = cases.length > 1 ? `, the best of ${cases.length} policies` : '';
  return el(
    'p',
    {class: 'answer'},
    el('b', {}, number(best.mean)),
    ' ',
    tipped(title, objective),
    ` in ${best.scenario}: `,
    tipped(spelled(best.policy), best.policy),
    `${choice}, ${spelled(best.detection)}, the mean of ${steps} steps${interval}`,
  );
}

const greatest = (rows, name) =>
  rows.reduce((most, row) => (Number(row[name]) > Number(most[name]) ? row : most));

/**
 * The largest share of the score that is lost if a rung of a ladder chooses the policy, and the
 * simplest rung that loses next to nothing; in a list, empty if it is not known.
 */
export function worthOfRealism(rows) {
  const rungs = rows.filter(({scenario, share}) => scenario === 'all' && share !== '');
  if (!rungs.length) return [];
  const worst = greatest(rungs, 'share');
  const enough = rungs.find(({share}) => Number(share) < NEGLIGIBLE_LOSS);
  const loss = percent(NEGLIGIBLE_LOSS);
  return [
    el(
      'p',
      {class: 'answer'},
      el('b', {}, percent(Number(worst.share))),
      ' of the best policy’s score is lost at most, ' +
        `where ${spelled(worst.rung)} chooses the policy`,
      enough ? `; ${spelled(enough.rung)} is the simplest rung that loses less than ${loss}` : '',
      `, judged by ${spelled(rungs.at(-1).rung)}, the mean of the scenarios`,
    ),
  ];
}

/** What a reader has to know before any proportion of the optimum. */
export function worthOfAdapting(rows) {
  const same = rows.filter(row => row.same_every_step === 'true').length;
  const most = Math.max(...rows.map(row => Number(row.value_of_adapting)));
  return el(
    'p',
    {class: 'notice'},
    'The optimum is static: one zoom for all cameras, never changed, has its k_min at every step ' +
      `in ${same} of ${rows.length} cases; ` +
      `at best, adapting the zoom is worth ${most.toFixed(2)} of a fixed one.`,
  );
}
