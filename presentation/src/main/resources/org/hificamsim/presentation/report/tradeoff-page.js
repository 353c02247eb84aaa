// The page of a study of CamSim's network: utility against cost of every network, the fronts, and who does what in the one that is chosen.
import {el, style} from './dom.js';
import {rowsOf, sortable} from './table.js';

const KINDS = [
  ['bandit', '--unseen', 4],
  ['heterogeneous', '--twice', 3],
  ['homogeneous', '--cameras', 5.5],
];
const SIZE = {width: 640, height: 460, left: 74, right: 28, top: 14, bottom: 48};
const WORDS = {A: 'Active', P: 'Passive', HA: 'HistActive', HP: 'HistPassive'};
const POLICIES = ['Broadcast', 'Smooth', 'Step', 'Fix'];
const STEPS = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2];
const TICKS = 5;
const percent = share => `${Number((100 * share).toFixed(1))} %`;
const estimate = (row, name, digits) =>
  `${Number(row[name]).toFixed(digits)}${row[`${name}_low`] === '' ? '' : ` [${Number(row[`${name}_low`]).toFixed(digits)}, ${Number(row[`${name}_high`]).toFixed(digits)}]`}`;

/** The page; `data` is what TradeoffReport wrote. */
export async function tradeoffPage(root, data) {
  root.append(el('header', {}, el('h1', {}, 'Trade-off', el('small', {}, data.title))));
  const networks = rowsOf(data.networks);
  const fronts = rowsOf(data.fronts);
  for (const scenario of new Set(networks.map(row => row.scenario))) {
    root.append(
      group(
        data,
        networks.filter(row => row.scenario === scenario),
        fronts.filter(row => row.scenario === scenario),
        scenario,
      ),
    );
  }
  root.append(
    card(
      'Fronts',
      el(
        'div',
        {class: 'scroll'},
        sortable(
          'hypervolume and what it gains on the homogeneous networks, with 95 % intervals over seeds',
          [
            {name: 'scenario'},
            {name: 'detection'},
            {name: 'networks'},
            {name: 'count'},
            {name: 'on_front', label: 'on the front'},
            {name: 'hypervolume', show: (text, row) => estimate(row, 'hypervolume', 3)},
            {name: 'gain', show: (text, row) => estimate(row, 'gain', 3)},
          ],
          fronts,
        ),
      ),
    ),
  );
  const verdicts = rowsOf(data.verdicts);
  if (verdicts.length) {
    root.append(
      card(
        'What papers say',
        el(
          'div',
          {class: 'scroll'},
          sortable(
            'statements of Esterle et al. (TOSN 2014) and Lewis et al. (TAAS 2015), judged by these networks',
            [
              {name: 'claim', label: 'statement'},
              {name: 'source'},
              {name: 'verdict'},
              {name: 'why', label: 'checks that hold, and the weakest margin'},
            ],
            verdicts,
          ),
        ),
      ),
    );
  }
  root.append(
    card(
      'Made with',
      el('pre', {tabindex: 0}, data.command),
      el('p', {class: 'note'}, `HiFi-CamSim ${data.version}`),
    ),
  );
  root.dataset.ready = '';
}

const card = (title, ...children) =>
  el('section', {class: 'card'}, el('h2', {}, title), ...children);

function svg(tag, attributes, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

function group(data, networks, fronts, scenario) {
  const told = el(
    'div',
    {class: 'note', 'aria-live': 'polite'},
    'Choose a point, or a network of the front, to see the strategy of each camera.',
  );
  const show = row => told.replaceChildren(...details(data, row));
  const front = names(fronts, 'static')
    .map(name => networks.find(row => row.network === name))
    .filter(Boolean);
  const buttons = front.map(row =>
    el('button', {type: 'button', onclick: () => show(row)}, row.network),
  );
  return card(
    `${scenario}, ${networks[0].detection}`,
    picture(networks, front, show),
    legend(networks),
    el('p', {class: 'networks'}, 'On the front, by rising cost: ', ...buttons),
    told,
  );
}

const names = (fronts, set) => (fronts.find(row => row.networks === set)?.front ?? '').split(' ');

/** Places along an axis of round shares that ends at 1 and begins below the least. */
function axis(networks, share, from, to) {
  const span = 1 - Math.min(...networks.map(row => Number(row[share])));
  const step = STEPS.find(one => span / one <= TICKS) ?? 0.2;
  const count = Math.min(Math.ceil(span / step + 0.1), Math.round(1 / step));
  const at = value => to - ((1 - Number(value)) / (step * count)) * (to - from);
  return {
    of: row => at(row[share]),
    at,
    ticks: Array.from({length: count + 1}, (_, i) => 1 - step * (count - i)),
  };
}

function picture(networks, front, show) {
  const across = axis(networks, 'cost_share', SIZE.left, SIZE.width - SIZE.right);
  const up = axis(networks, 'utility_share', SIZE.height - SIZE.bottom, SIZE.top);
  const [x, y] = [across.of, up.of];
  const ink = 'currentColor';
  const [foot, side] = [SIZE.height - SIZE.bottom, SIZE.width - SIZE.right];
  const axes = [
    ...across.ticks.flatMap(share => [
      svg('line', {
        x1: across.at(share),
        x2: across.at(share),
        y1: foot,
        y2: SIZE.top,
        stroke: ink,
        'stroke-opacity': 0.12,
      }),
      svg(
        'text',
        {x: across.at(share), y: foot + 18, 'text-anchor': 'middle', fill: ink, 'font-size': 12},
        percent(share),
      ),
    ]),
    ...up.ticks.flatMap(share => [
      svg('line', {
        x1: SIZE.left,
        x2: side,
        y1: up.at(share),
        y2: up.at(share),
        stroke: ink,
        'stroke-opacity': 0.12,
      }),
      svg(
        'text',
        {x: SIZE.left - 8, y: up.at(share) + 4, 'text-anchor': 'end', fill: ink, 'font-size': 12},
        percent(share),
      ),
    ]),
  ];
  const titles = [
    svg(
      'text',
      {
        x: (SIZE.left + SIZE.width) / 2,
        y: SIZE.height - 8,
        'text-anchor': 'middle',
        fill: ink,
        'font-size': 13,
      },
      'cost, of the largest',
    ),
    svg(
      'text',
      {
        transform: `translate(16 ${SIZE.height / 2}) rotate(-90)`,
        'text-anchor': 'middle',
        fill: ink,
        'font-size': 13,
      },
      'utility, of the largest',
    ),
  ];
  const steps = front
    .map((row, i) => (i ? `H ${x(row)} V ${y(row)}` : `M ${x(row)} ${y(row)}`))
    .join(' ');
  const points = [...KINDS]
    .sort((a, b) => a[2] - b[2])
    .flatMap(([kind, colour, r]) =>
      networks
        .filter(row => row.kind === kind)
        .map(row =>
          svg(
            'circle',
            {
              'data-network': row.network,
              cx: x(row),
              cy: y(row),
              r,
              fill: style(colour),
              'fill-opacity': kind === 'heterogeneous' ? 0.55 : 0.95,
              cursor: 'pointer',
              onclick: () => show(row),
            },
            svg(
              'title',
              {},
              `${row.network}: utility ${percent(row.utility_share)}, cost ${percent(row.cost_share)}`,
            ),
          ),
        ),
    );
  return svg(
    'svg',
    {
      viewBox: `0 0 ${SIZE.width} ${SIZE.height}`,
      role: 'img',
      'aria-label': 'Utility against cost of all networks, with the front',
      class: 'tradeoff',
    },
    ...axes,
    ...titles,
    ...points,
    svg('path', {
      d: steps,
      fill: 'none',
      stroke: ink,
      'stroke-width': 1.5,
      'pointer-events': 'none',
    }),
  );
}

function legend(networks) {
  const there = KINDS.filter(([kind]) => networks.some(row => row.kind === kind));
  const mark = colour =>
    svg(
      'svg',
      {width: 14, height: 12, 'aria-hidden': 'true'},
      svg('circle', {cx: 6, cy: 6, r: 5, fill: style(colour)}),
    );
  return el(
    'p',
    {class: 'note'},
    ...there.flatMap(([kind, colour]) => [mark(colour), `${kind} `]),
    'The line is the front of strategies that never change.',
  );
}

const spelled = code => `${WORDS[code.slice(0, -1)] ?? code} ${POLICIES[code.slice(-1)] ?? ''}`;

/** What a network is: each camera's strategy, its figures, its replay. */
function details(data, row) {
  const cameras = data.cameras[row.scenario] ?? [];
  const codes = row.network.split('-');
  const who =
    row.kind === 'bandit'
      ? `all cameras choose by ${row.network.replace('@', ', alpha ')}`
      : codes.length === 1
        ? `all cameras: ${spelled(codes[0])}`
        : codes.map((code, i) => `${cameras[i] ?? `camera ${i + 1}`}: ${spelled(code)}`).join('; ');
  const replay = data.replays[`${row.scenario}-${row.network}`];
  return [
    el('p', {}, el('b', {}, row.network), ` (${row.kind}): ${who}`),
    el('p', {}, `utility ${estimate(row, 'utility', 2)}, cost ${estimate(row, 'cost', 0)}`),
    replay ? el('p', {}, el('a', {href: replay}, 'Replay of the first seed')) : null,
    el('pre', {tabindex: 0}, data.runs[row.scenario].replace('NETWORK', row.option)),
  ].filter(Boolean);
}
