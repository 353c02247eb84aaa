// Heat maps of a ladder: for each scenario, the order of the policies under each rung.
import {card, scrollBox} from './cards.js';
import {el} from './dom.js';
import {spelled} from './names.js';
import {decimals, percent} from './numbers.js';
import {distinct, rowsOf} from './table.js';

const STRONGEST = 45; // percent of the accent colour behind the best policy; text stays readable
const DECIMALS = 3;

/** Returns a card with the heat maps of the tables ladder.csv and rungs.csv. */
export function ladderMaps(ladder, rungs) {
  const [ranks, losses] = [rowsOf(ladder), rowsOf(rungs)];
  const maps = distinct(ranks, 'scenario').map(scenario =>
    map(
      scenario,
      ranks.filter(row => row.scenario === scenario),
      losses.filter(row => row.scenario === scenario),
    ),
  );
  return card(
    'The order of the policies by rung',
    el('div', {class: 'maps'}, ...maps),
    el(
      'p',
      {class: 'note'},
      '1 is the best policy under a rung; policies that tie share a place. The top rung, which ' +
        'judges the others, is the first row, and its best policy the first column. Lost: the ' +
        'share of the best score under the top rung that is lost if a rung chooses the policy.',
    ),
  );
}

function map(scenario, ranks, losses) {
  const rungs = distinct(ranks, 'rung').reverse();
  const policies = ranks
    .filter(({rung}) => rung === rungs[0])
    .sort((a, b) => a.rank - b.rank)
    .map(({policy}) => policy);
  const head = name => el('th', {scope: 'col', title: name}, spelled(name));
  const lines = rungs.map(rung =>
    el(
      'tr',
      {},
      el('th', {scope: 'row', title: rung}, spelled(rung)),
      ...policies.map(policy =>
        rankCell(
          ranks.find(row => row.rung === rung && row.policy === policy),
          policies.length,
        ),
      ),
      el('td', {}, lost(losses.find(row => row.rung === rung))),
    ),
  );
  const heads = [el('td'), ...policies.map(head), el('th', {scope: 'col'}, 'lost')];
  const caption = el('caption', {}, scenario);
  const body = el('tbody', {}, ...lines);
  const table = el(
    'table',
    {class: 'ranks'},
    caption,
    el('thead', {}, el('tr', {}, ...heads)),
    body,
  );
  return scrollBox(`Order of policies, ${scenario}`, table);
}

function rankCell({rank, mean_k_min: score}, count) {
  const strength = (STRONGEST * (count - rank)) / Math.max(1, count - 1);
  const colour = `color-mix(in srgb, var(--accent) ${strength}%, transparent)`;
  const title = `mean score of a step: ${decimals(Number(score), DECIMALS)}`;
  const cell = el('td', {class: 'rank', title}, rank);
  cell.style.background = colour;
  return cell;
}

const lost = row => (!row || row.share === '' ? '–' : percent(Number(row.share)));
