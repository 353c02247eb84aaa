// The plot of a scenario's networks: utility against cost, with the front.
import {svg} from './cards.js';
import {el, style} from './dom.js';
import {percent} from './numbers.js';

/** The kinds of networks, with the colour and radius of their points. */
const KINDS = [
  ['bandit', '--unseen', 4],
  ['heterogeneous', '--twice', 3],
  ['homogeneous', '--cameras', 5.5],
];
const NARROW = 600; // pixels; in a narrower window, a large plot's words would be unreadable
const IS_NARROW = innerWidth < NARROW;
const SIZE = {
  ...(IS_NARROW ? {width: 360, height: 320} : {width: 640, height: 460}),
  left: 74,
  right: 28,
  top: 14,
  bottom: 48,
};
const BOTTOM = SIZE.height - SIZE.bottom;
const RIGHT = SIZE.width - SIZE.right;
const INK = 'currentColor';
const MARGIN = 14;
const LETTER = {width: 7, height: 13};
const MOST_NAMES = 3;
const TICK_GAPS = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2];
const MOST_GAPS = 5;

/**
 * Returns the plot as an SVG element.
 * @param networks all networks of the scenario
 * @param front the networks of the front, by rising cost
 * @param show is called with the network whose point is clicked
 */
export function networkPlot(networks, front, show) {
  const across = axis(networks, 'cost_share', SIZE.left, RIGHT);
  const up = axis(networks, 'utility_share', BOTTOM, SIZE.top);
  const [x, y] = [across.placeOf, up.placeOf];
  const steps = front.map((row, i) =>
    i ? `H ${x(row)} V ${y(row)}` : `M ${x(row)} ${BOTTOM} V ${y(row)}`,
  );
  const points = [...KINDS]
    .sort(([, , r], [, , otherR]) => r - otherR)
    .flatMap(([kind, colour, r]) =>
      networks
        .filter(row => row.kind === kind)
        .map(row => point(row, {cx: x(row), cy: y(row), r, fill: style(colour)}, show)),
    );
  return svg(
    'svg',
    {
      viewBox: `0 0 ${SIZE.width} ${SIZE.height}`,
      role: 'img',
      'aria-label': 'Utility against cost of all networks, with the front',
      class: 'tradeoff',
    },
    ...across.ticks.flatMap(share => verticalLine(share, across.place(share))),
    ...up.ticks.flatMap(share => horizontalLine(share, up.place(share))),
    ...titles(),
    ...points,
    svg('path', {
      d: front.length ? `${steps.join(' ')} H ${RIGHT}` : '',
      fill: 'none',
      stroke: INK,
      'stroke-width': 1.5,
      'pointer-events': 'none',
    }),
    ...labels(front.map((row, i) => ({name: labelOf(row, i), x: x(row), y: y(row)}))),
  );
}

/** The label of a point: its name or, in a small plot where names would overlap, its number. */
const labelOf = (row, i) => (IS_NARROW ? String(i + 1) : row.network);

/** The number that marks a network of the front in a small plot, with a colon; otherwise empty. */
export const numberPrefix = i => (IS_NARROW ? `${i + 1}: ` : '');

/** The labels of the front's points; names that would overlap share one label. */
function labels(points) {
  const groups = [];
  for (const {name, x, y} of points) {
    const last = groups.at(-1);
    const isNear = last && x - last.x < widthOf(name) && last.y - y < LETTER.height;
    if (isNear) Object.assign(last, {names: [...last.names, name], y});
    else groups.push({names: [name], x, y});
  }
  return groups.map(({names, x, y}) => {
    const name = names.length > MOST_NAMES ? `${names.length} networks` : names.join(', ');
    const fits = x - widthOf(name) > SIZE.left;
    const place = {x: fits ? x - 7 : x + 8, y: Math.max(y - 7, SIZE.top + LETTER.height)};
    return text({...place, 'text-anchor': fits ? 'end' : 'start', class: 'front-name'}, name);
  });
}

const widthOf = name => LETTER.width * name.length;

/** An axis of round shares, which ends at 1 and begins below the least share. */
function axis(networks, share, from, to) {
  const span = 1 - Math.min(...networks.map(row => Number(row[share])));
  const gap = TICK_GAPS.find(width => span / width <= MOST_GAPS) ?? 0.2;
  const count = Math.min(Math.ceil(span / gap + 0.1), Math.round(1 / gap));
  const end = to + (to > from ? -MARGIN : MARGIN); // leaves space for points and names at 1
  const place = value => end - ((1 - Number(value)) / (gap * count)) * (end - from);
  return {
    place,
    placeOf: row => place(row[share]),
    ticks: Array.from({length: count + 1}, (none, i) => 1 - gap * (count - i)),
  };
}

const gridLine = ends => svg('line', {...ends, stroke: INK, 'stroke-opacity': 0.12});

const verticalLine = (share, x) => [
  gridLine({x1: x, x2: x, y1: BOTTOM, y2: SIZE.top}),
  text({x, y: BOTTOM + 18, 'text-anchor': 'middle', 'font-size': 12}, percent(share)),
];

const horizontalLine = (share, y) => [
  gridLine({x1: SIZE.left, x2: RIGHT, y1: y, y2: y}),
  text({x: SIZE.left - 8, y: y + 4, 'text-anchor': 'end', 'font-size': 12}, percent(share)),
];

const titles = () => [
  text(
    {
      x: (SIZE.left + SIZE.width) / 2,
      y: SIZE.height - 8,
      'text-anchor': 'middle',
      'font-size': 13,
    },
    'cost, of the largest',
  ),
  text(
    {
      transform: `translate(16 ${SIZE.height / 2}) rotate(-90)`,
      'text-anchor': 'middle',
      'font-size': 13,
    },
    'utility, of the largest',
  ),
];

const text = (attributes, content) => svg('text', {...attributes, fill: INK}, content);

function point(row, circle, show) {
  const title = `utility ${percent(row.utility_share)}, cost ${percent(row.cost_share)}`;
  return svg(
    'circle',
    {
      ...circle,
      'data-network': row.network,
      'fill-opacity': row.kind === 'heterogeneous' ? 0.55 : 0.95,
      cursor: 'pointer',
      onclick: () => show(row),
    },
    svg('title', {}, `${row.network}: ${title}`),
  );
}

/** The legend of a plot: the kinds of networks that it has. */
export function networkLegend(networks) {
  const present = KINDS.filter(([kind]) => networks.some(row => row.kind === kind));
  const mark = colour =>
    svg(
      'svg',
      {width: 14, height: 12, 'aria-hidden': 'true'},
      svg('circle', {cx: 6, cy: 6, r: 5, fill: style(colour)}),
    );
  return el(
    'p',
    {class: 'note'},
    ...present.flatMap(([kind, colour]) => [mark(colour), `${kind}; `]),
    'the line is the front of strategies that never change',
  );
}
