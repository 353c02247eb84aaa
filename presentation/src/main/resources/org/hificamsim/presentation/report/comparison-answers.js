// The sentences at the top of a comparison's page: what was found, in the objective's words.
import {el} from './dom.js';
import {scoreNumber, spelled, tipped} from './names.js';
import {percent} from './numbers.js';
import {distinct, rowsOf} from './table.js';
import {YARDSTICKS} from './yardsticks.js';

const MOST_ANSWERS = 4;
const MOST_WINNERS = 3;
const MOST_PROMISES = 2;
const NEGLIGIBLE_LOSS = 0.01;
const MISLEADING = 0.1;

/** What the shares of yardsticks are shares of, the leading yardstick first. */
const SHARES = {
  proportion_of_optimal: 'the optimum',
  proportion_of_bound: 'what is possible',
  proportion_of_reachable: 'what cameras could reach in time',
};

/**
 * For each of the first scenarios, a sentence on the best deployable policy under the last
 * detection, which is the most realistic, and on what the other detections would have chosen.
 */
export function bestScores(data) {
  const {summary, settings} = data;
  if (!summary || !settings?.[0]?.score_words) return [];
  const rows = rowsOf(summary);
  const scores = rows.filter(({metric, mean}) => metric === 'mean_score' && mean !== '');
  return distinct(scores, 'scenario')
    .slice(0, MOST_ANSWERS)
    .map(scenario => deployable(scores.filter(row => row.scenario === scenario)))
    .filter(cases => cases.length)
    .map(cases => bestScore(cases, rows, data));
}

const deployable = rows =>
  rows.filter(
    ({detection, policy}) => detection === rows.at(-1).detection && !YARDSTICKS.includes(policy),
  );

function bestScore(cases, rows, {settings, tables}) {
  const best = greatest(cases, 'mean');
  const plan = settings.find(({scenario}) => scenario === best.scenario);
  const number = score => scoreNumber(Number(score), {share: plan.score_unit === 'share'});
  const interval =
    number(best.low) === number(best.high)
      ? ''
      : ` (95 % interval ${number(best.low)} to ${number(best.high)})`;
  const winners = cases.filter(({mean}) => mean === best.mean);
  const names = winners.length > MOST_WINNERS ? `${winners.length} policies` : listed(winners);
  const verb = winners.length > 1 ? 'tie as' : 'is';
  const choice = cases.length > 1 ? ` ${verb} the best of ${cases.length} policies: ` : ': ';
  return el(
    'p',
    {class: 'answer'},
    `${best.scenario}: `,
    names,
    choice,
    el('b', {}, number(best.mean)),
    ' ',
    tipped(plan.score_words, plan.objective),
    `, mean of ${plan.steps} steps${interval}`,
    shareText(rows.filter(row => isSameCase(row, best))),
    `, with ${spelled(best.detection)}.`,
    misleading(best, number, tables),
  );
}

/** The policies in words, such as "a, b and c". */
const listed = rows =>
  rows
    .map(({policy}) => spelled(policy))
    .join(', ')
    .replace(/, ([^,]*)$/, ' and $1');

const isSameCase = (row, other) =>
  ['scenario', 'detection', 'policy'].every(name => row[name] === other[name]);

/** The share that a case reaches of the first yardstick that is known; empty without one. */
function shareText(rows) {
  const [metric, words] =
    Object.entries(SHARES).find(([name]) =>
      rows.some(row => row.metric === name && row.mean !== ''),
    ) ?? [];
  if (!metric) return '';
  const share = Number(rows.find(row => row.metric === metric).mean);
  return metric === 'proportion_of_optimal'
    ? `, ${percent(share)} of ${words}`
    : `, at least ${percent(Math.floor(1000 * share) / 1000)} of ${words}`;
}

/** What other detections promise of the policies that they would choose, where it misleads. */
function misleading(best, number, tables) {
  const table = tables.find(({name}) => name === 'choices.csv');
  const choices = table
    ? rowsOf(table).filter(
        ({scenario, detection}) => scenario === best.scenario && detection !== best.detection,
      )
    : [];
  return choices
    .slice(0, MOST_PROMISES)
    .map(choice => promise(choice, best, number))
    .join('');
}

function promise({detection, chosen, predicted, achieved}, best, number) {
  const choices = chosen.split(' | ');
  const isBest = choices.includes(best.policy) || isNear(achieved, best.mean, NEGLIGIBLE_LOSS);
  if (!isBest)
    return (
      ` ${spelled(detection)} would choose ${choices.map(spelled).join(' or ')}` +
      ` and promise ${number(predicted)}; that policy reaches ${number(achieved)}.`
    );
  return isNear(predicted, best.mean, MISLEADING)
    ? ''
    : ` With ${spelled(detection)} it would seem to be ${number(predicted)}.`;
}

const isNear = (value, other, share) => Math.abs(value - other) <= share * other;

const greatest = (rows, name) =>
  rows.reduce((most, row) => (Number(row[name]) > Number(most[name]) ? row : most));

/**
 * Returns a list with one sentence: which simplest rung of a ladder chooses a policy that loses
 * next to nothing, or else which rung loses least. The list is empty for fewer than two rungs.
 */
export function worthOfRealism(rows) {
  const rungs = rows.filter(({scenario, share}) => scenario === 'all' && share !== '');
  if (rungs.length < 2) return [];
  const top = spelled(rungs.at(-1).rung);
  const simpler = rungs.slice(0, -1);
  const enough = simpler.find(({share}) => Number(share) < NEGLIGIBLE_LOSS);
  const least =
    enough ??
    greatest(
      simpler.map(row => ({...row, kept: 1 - row.share})),
      'kept',
    );
  const claim = enough
    ? 'is the simplest rung that is real enough'
    : 'comes closest to the top rung';
  return [
    el(
      'p',
      {class: 'answer'},
      `${spelled(least.rung)} ${claim}: the policy that it chooses loses `,
      el('b', {}, percent(Number(least.share))),
      ` of the best policy’s score under ${top}, the mean of the scenarios. `,
      least === simpler[0] ? null : firstRung(simpler[0]),
    ),
  ];
}

const firstRung = ({rung, share}) =>
  `${spelled(rung)}, the simplest of all, loses ${percent(Number(share))}.`;

/** Warns that the optimum is static, which proportions of the optimum do not show. */
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
