// Builds the page of a study of CamSim's network: the networks and fronts of each scenario, and
// verdicts on statements in papers.
import {card, madeWith} from './cards.js';
import {el} from './dom.js';
import {spelled} from './names.js';
import {percent, significant} from './numbers.js';
import {distinct, rowsOf, sortable} from './table.js';
import {networkLegend, networkPlot, numberPrefix} from './tradeoff-plot.js';

const SCHEDULES = {A: 'Active', P: 'Passive', HA: 'HistActive', HP: 'HistPassive'};
const POLICIES = ['Broadcast', 'Smooth', 'Step', 'Fix'];

/** Builds the page from data that TradeoffReport wrote. */
export async function tradeoffPage(root, data) {
  root.append(el('header', {}, el('h1', {}, 'Trade-off', el('small', {}, data.title))));
  const networks = rowsOf(data.networks);
  const fronts = rowsOf(data.fronts);
  const studies = distinct(networks, 'scenario').map(scenario => {
    const inScenario = row => row.scenario === scenario;
    return [networks.filter(inScenario), fronts.filter(inScenario)];
  });
  root.append(...studies.map(study => answer(...study)));
  root.append(...studies.map(study => scenarioCard(data, ...study)));
  root.append(frontCard(fronts));
  const verdicts = rowsOf(data.verdicts);
  if (verdicts.length) root.append(verdictCard(verdicts));
  root.append(madeWith(data));
  root.dataset.ready = '';
}

/** Says how many networks are on the front, their range, and what heterogeneous ones add to it. */
function answer(networks, fronts) {
  const front = frontOf(networks, fronts);
  const gain = Number(fronts.find(row => row.networks === 'static')?.gain ?? 0);
  const part = row =>
    `${row.network} with ${percent(Number(row.utility_share))} of the utility for ` +
    `${percent(Number(row.cost_share))} of the cost`;
  const ends = [...new Set([front[0], front.at(-1)])].filter(Boolean);
  const range = ends.length > 1 ? `, from ${ends.map(part).join(' to ')}` : `: ${ends.map(part)}`;
  const wider =
    gain > 0 ? ` Networks whose cameras differ add ${significant(gain)} to its hypervolume.` : '';
  return el(
    'p',
    {class: 'answer'},
    `${networks[0].scenario}: `,
    el('b', {}, `${front.length} of ${networks.length}`),
    ` networks ${front.length === 1 ? 'is' : 'are'} on the front of utility over cost` +
      `${range}.${wider}`,
  );
}

/** The networks of a front, by rising cost. */
const frontOf = (networks, fronts) =>
  (fronts.find(row => row.networks === 'static')?.front ?? '')
    .split(' ')
    .map(name => networks.find(row => row.network === name))
    .filter(Boolean);

/** The card of one scenario's networks: a plot, the front, and the details of a chosen network. */
function scenarioCard(data, networks, fronts) {
  const chosen = el(
    'div',
    {class: 'note', 'aria-live': 'polite'},
    'Choose a point, or a network of the front, to see the strategy of each camera.',
  );
  const show = row => chosen.replaceChildren(...details(data, row));
  const front = frontOf(networks, fronts);
  const title = row => shortStrategy(row, data.cameras[row.scenario] ?? []);
  const buttons = front.map((row, i) =>
    el(
      'button',
      {type: 'button', title: row.network, onclick: () => show(row)},
      numberPrefix(i) + title(row),
    ),
  );
  return card(
    `${networks[0].scenario}, ${spelled(networks[0].detection)}`,
    networkPlot(networks, front, show),
    networkLegend(networks),
    el('p', {class: 'networks'}, 'On the front, by rising cost: ', ...buttons),
    chosen,
  );
}

/** A network in words, or its short name if its cameras differ. */
const shortStrategy = (row, cameras) =>
  row.network.includes('-')
    ? row.network
    : strategiesOf(row, cameras).replace('all cameras: ', `${row.network}, `);

/** The card of fronts; equal fronts share a row. */
function frontCard(fronts) {
  const columns = [
    {name: 'scenario'},
    {name: 'detection', show: spelled},
    {name: 'networks'},
    {name: 'count'},
    {name: 'on_front', label: 'on the front'},
    {name: 'hypervolume', show: (text, row) => estimate(row, 'hypervolume', 3)},
    {
      name: 'gain',
      show: (text, row) => (row.homogeneous ? '–' : estimate(row, 'gain', 3)),
    },
  ];
  const isVaried = ({name}) =>
    !['scenario', 'detection'].includes(name) || distinct(fronts, name).length > 1;
  return card(
    'Fronts',
    el(
      'div',
      {class: 'scroll'},
      sortable(
        'hypervolume and what it gains on the homogeneous networks, ' +
          'with 95 % intervals over seeds; sets of networks with the same front share a row',
        columns.filter(isVaried),
        merged(fronts),
      ),
    ),
  );
}

/** Merges the rows of sets of networks that have the same front. */
function merged(fronts) {
  const rows = new Map();
  for (const row of fronts) {
    const key = [row.scenario, row.detection, row.front].join(';');
    const homogeneous = row.networks === 'homogeneous';
    const other = rows.get(key);
    rows.set(key, {
      ...row,
      homogeneous: homogeneous || other?.homogeneous,
      networks: other ? `${other.networks}, ${row.networks}` : row.networks,
      count: String(Math.max(Number(row.count), Number(other?.count ?? 0))),
    });
  }
  return [...rows.values()];
}

const verdictCard = verdicts =>
  card(
    'What papers say',
    el(
      'div',
      {class: 'scroll'},
      sortable(
        'statements of Esterle et al. (TOSN 2014) and Lewis et al. (TAAS 2015), ' +
          'judged by these networks',
        [
          {name: 'claim', label: 'statement'},
          {name: 'source'},
          {name: 'verdict'},
          {name: 'why', label: 'checks that hold, and the weakest margin'},
        ],
        verdicts,
      ),
    ),
  );

/** The details of a network: each camera's strategy, figures, recording, and the command. */
function details(data, row) {
  const replay = data.replays[`${row.scenario}-${row.network}`];
  const strategies = strategiesOf(row, data.cameras[row.scenario] ?? []);
  return [
    el('p', {}, el('b', {}, row.network), ` (${row.kind}): ${strategies}`),
    el('p', {}, `utility ${estimate(row, 'utility', 2)}, cost ${estimate(row, 'cost', 0)}`),
    replay ? el('p', {}, el('a', {href: replay}, 'Replay of the first seed')) : null,
    el('pre', {tabindex: 0}, data.runs[row.scenario].replace('NETWORK', row.option)),
  ].filter(Boolean);
}

function strategiesOf({kind, network}, cameras) {
  if (kind === 'bandit') return `all cameras choose by ${network.replace('@', ', alpha ')}`;
  const codes = network.split('-');
  if (codes.length === 1) return `all cameras: ${strategyName(codes[0])}`;
  return codes
    .map((code, i) => `${cameras[i] ?? `camera ${i + 1}`}: ${strategyName(code)}`)
    .join('; ');
}

/** The name of a strategy, whose code is a schedule and the number of a communication policy. */
const strategyName = code =>
  `${SCHEDULES[code.slice(0, -1)] ?? code} ${POLICIES[code.slice(-1)] ?? ''}`;

/** A figure of a row with its interval, if it has one. */
function estimate(row, name, digits) {
  const number = column => Number(row[column]).toFixed(digits);
  const interval =
    row[`${name}_low`] === '' ? '' : ` [${number(`${name}_low`)}, ${number(`${name}_high`)}]`;
  return number(name) + interval;
}
