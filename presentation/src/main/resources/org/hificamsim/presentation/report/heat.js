// A heat map's figures, one at a time: the choice among them, their key, and what is said of a cell.
import {el} from './dom.js';
import {inflate} from './inflate.js';
import {optional, SeriesReader} from './recording.js';
import {scaleColour} from './palette.js';
import {decimals, percent} from './numbers.js';

/** The heat map that the record PackedHeat holds: each of its figures with the values of the cells. */
export async function unpackHeat(packed) {
  const reader = new SeriesReader(await inflate(packed.data));
  const values = () => reader.series(packed.columns * packed.rows, optional(packed.perUnit));
  return {...packed, figures: packed.figures.map(figure => ({...figure, values: values()}))};
}

export class HeatChoice {
  /**
   * @param figures name and label of each
   * @param chosen is called with a figure's name, or with '' for none
   */
  constructor(field, figures, chosen) {
    this.field = field;
    this.select = el(
      'select',
      {name: 'heat', onchange: () => chosen(this.select.value)},
      el('option', {value: ''}, 'none'),
      ...figures.map(({name, label}) => el('option', {value: name}, label)),
    );
    this.key = el('span', {class: 'heat-key', hidden: true});
  }

  /** The figure that is shown, if there is a map. */
  get shown() {
    return this.heat?.figures.find(({name}) => name === this.select.value);
  }

  /** Takes another map. */
  load(heat) {
    this.heat = heat;
    this.explain();
  }

  /** Takes another figure by its name; '' for none. */
  choose(name) {
    this.select.value = name;
    this.explain();
  }

  /** The scale from end to end, what has a look of its own, and what the map is of. */
  explain() {
    const {heat, shown} = this;
    this.key.hidden = !this.select.value;
    if (!shown) return void this.key.replaceChildren('from the next step on');
    const {least, most, never, values} = shown;
    const colours = Array.from({length: 9}, (none, i) => `rgb(${scaleColour(i / 8).join(' ')})`);
    const bar = el('i', {
      class: 'heat-bar',
      role: 'img',
      'aria-label': `from ${least}, dark, to ${most}, light`,
    });
    bar.style.background = `linear-gradient(to right, ${colours.join(', ')})`;
    const steps = `${heat.steps} step${heat.steps === 1 ? '' : 's'}${heat.first ? ` from ${heat.first} on` : ''}`;
    this.key.replaceChildren(
      el('span', {}, least, bar, most),
      ...(values.includes(0) ? [el('span', {}, el('i', {class: 'heat-never'}), never)] : []),
      el('span', {class: 'heat-steps'}, `${steps}: ${this.summary()}`),
    );
  }

  summary() {
    const {areaCovered, areaCoveredK, areaBlind} = this.heat;
    return `of area and steps ${percent(areaCovered)} with 1 or more cameras, ${percent(areaCoveredK)} with 2 or more; of the area ${percent(areaBlind)} never`;
  }

  /** What is said of a place in metres. */
  describe(x, y) {
    const {minX, maxX, minY, maxY} = this.field;
    if (!this.shown || x < minX || x > maxX || y < minY || y > maxY) return [];
    const {rows, columns, figures} = this.heat;
    const at = (place, from, to, count) =>
      to > from ? Math.min(count - 1, Math.floor(((place - from) / (to - from)) * count)) : 0;
    const cell = at(y, minY, maxY, rows) * columns + at(x, minX, maxX, columns);
    const of = name => figures.find(figure => figure.name === name).values[cell];
    const share = name => percent(1 - of(name));
    return [
      Number.isNaN(of('mean-k'))
        ? 'in an obstacle'
        : `${decimals(of('mean-k'), 2)} cameras in the mean, none in ${share('covered')} of the steps`,
      ...(of('visits')
        ? [
            `${of('visits')} visits: ${decimals(of('visits-mean-k'), 2)} cameras in the mean, none in ${share('visits-covered')}`,
          ]
        : []),
    ];
  }
}

/** For each zone, over its cells outside obstacles: in which share of steps one or more and two or more cameras cover it, and how much of it none ever does. */
export function zoneShares({columns, rows, figures}, {minX, maxX, minY, maxY}, zones) {
  const of = name => figures.find(figure => figure.name === name).values;
  const [covered, twice] = [of('covered'), of('covered-k')];
  const middle = cell => [
    minX + (((cell % columns) + 0.5) * (maxX - minX)) / columns,
    minY + ((Math.floor(cell / columns) + 0.5) * (maxY - minY)) / rows,
  ];
  return zones.map(zone => {
    const cells = [...covered.keys()].filter(
      cell =>
        !Number.isNaN(covered[cell]) && contains(zone, ...middle(cell), (maxX - minX) / columns),
    );
    const mean = value => cells.reduce((sum, cell) => sum + value(cell), 0) / cells.length;
    return {
      zone,
      covered: mean(cell => covered[cell]),
      twice: mean(cell => twice[cell]),
      never: mean(cell => covered[cell] === 0),
    };
  });
}

/** Whether a zone has a place: a line is a strip as wide as a cell, so that it has cells. */
function contains({shape, points}, x, y, wide) {
  if (shape === 'FIELD') return true;
  const [one, other] = points;
  if (shape === 'RECTANGLE')
    return (x - one.x) * (x - other.x) <= 0 && (y - one.y) * (y - other.y) <= 0;
  const sides = points.map((to, i) => [points.at(i - 1), to]);
  if (shape === 'POLYGON')
    return (
      sides.filter(
        ([from, to]) =>
          from.y > y !== to.y > y &&
          x < from.x + ((to.x - from.x) * (y - from.y)) / (to.y - from.y),
      ).length %
        2 ===
      1
    );
  return sides.slice(1).some(([from, to]) => {
    const length = (to.x - from.x) ** 2 + (to.y - from.y) ** 2;
    const at = Math.max(
      0,
      Math.min(
        1,
        ((x - from.x) * (to.x - from.x) + (y - from.y) * (to.y - from.y)) / (length || 1),
      ),
    );
    return Math.hypot(x - from.x - at * (to.x - from.x), y - from.y - at * (to.y - from.y)) <= wide;
  });
}

/** The connected areas that no camera ever covered, the largest first: each with its box and size in square metres. */
export function blindSpots({columns, rows, figures}, {minX, maxX, minY, maxY}) {
  const blind = figures.find(({name}) => name === 'covered').values.map(share => share === 0);
  const [wide, high] = [(maxX - minX) / columns, (maxY - minY) / rows];
  const spots = [];
  for (let start = 0; start < blind.length; start++) {
    if (!blind[start]) continue;
    const spot = {cells: 0, minX: Infinity, maxX: -Infinity, minY: Infinity, maxY: -Infinity};
    const waiting = [start];
    blind[start] = false;
    while (waiting.length) {
      const cell = waiting.pop();
      const [column, row] = [cell % columns, Math.floor(cell / columns)];
      spot.cells++;
      Object.assign(spot, {
        minX: Math.min(spot.minX, minX + column * wide),
        maxX: Math.max(spot.maxX, minX + (column + 1) * wide),
        minY: Math.min(spot.minY, minY + row * high),
        maxY: Math.max(spot.maxY, minY + (row + 1) * high),
      });
      const next = [
        column > 0 && cell - 1,
        column < columns - 1 && cell + 1,
        cell - columns,
        cell + columns,
      ];
      for (const other of next) {
        if (other === false || !blind[other]) continue;
        blind[other] = false;
        waiting.push(other);
      }
    }
    spots.push({...spot, area: spot.cells * wide * high});
  }
  return spots.sort((a, b) => b.area - a.area);
}
