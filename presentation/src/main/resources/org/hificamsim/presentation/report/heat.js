// The choice of a heat map's figure, the key to its colours, and descriptions of cells.
import {el} from './dom.js';
import {inflate} from './inflate.js';
import {decimals, percent} from './numbers.js';
import {scaleColour} from './palette.js';
import {optional, SeriesReader} from './recording.js';

/**
 * Unpacks a record PackedHeat: returns it with the `values` of all cells in each of its figures.
 */
export async function unpackHeat(packed) {
  const reader = new SeriesReader(await inflate(packed.data));
  const values = () => reader.series(packed.columns * packed.rows, optional(packed.perUnit));
  return {...packed, figures: packed.figures.map(figure => ({...figure, values: values()}))};
}

export class HeatChoice {
  /**
   * @param field the borders of the field in metres
   * @param figures the name and label of each figure
   * @param onChoose is called with a figure's name, '' for none
   */
  constructor(field, figures, onChoose) {
    this.field = field;
    this.select = el(
      'select',
      {name: 'heat', onchange: () => onChoose(this.select.value)},
      el('option', {value: ''}, 'none'),
      ...figures.map(({name, label}) => el('option', {value: name}, label)),
    );
    this.key = el('span', {class: 'heat-key', hidden: true});
  }

  /** The figure that is shown; undefined if there is no map or none is chosen. */
  get shown() {
    return this.heat?.figures.find(({name}) => name === this.select.value);
  }

  load(heat) {
    this.heat = heat;
    this.writeKey();
  }

  /** Shows a figure by its name; '' for none. */
  choose(name) {
    this.select.value = name;
    this.writeKey();
  }

  /** Writes the scale, the sign of cells that are never covered, and the steps of the map. */
  writeKey() {
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
    const from = heat.first ? ` from ${heat.first} on` : '';
    const steps = `${heat.steps} step${heat.steps === 1 ? '' : 's'}${from}`;
    this.key.replaceChildren(
      el('span', {}, least, bar, most),
      ...(values.includes(0) ? [el('span', {}, el('i', {class: 'heat-never'}), never)] : []),
      el('span', {class: 'heat-steps'}, `${steps}: ${this.summary()}`),
    );
  }

  summary() {
    const {areaCovered, areaCoveredK, areaBlind} = this.heat;
    return (
      `of area and steps ${percent(areaCovered)} with 1 or more cameras, ` +
      `${percent(areaCoveredK)} with 2 or more; of the area ${percent(areaBlind)} never`
    );
  }

  /** Describes the cell at x and y, in metres: lines of text, none if no figure is shown there. */
  describe(x, y) {
    const {minX, maxX, minY, maxY} = this.field;
    if (!this.shown || x < minX || x > maxX || y < minY || y > maxY) return [];
    const {rows, columns, figures} = this.heat;
    const index = (coordinate, from, to, count) =>
      to > from ? Math.min(count - 1, Math.floor(((coordinate - from) / (to - from)) * count)) : 0;
    const cell = index(y, minY, maxY, rows) * columns + index(x, minX, maxX, columns);
    const valueOf = name => figures.find(figure => figure.name === name).values[cell];
    const mean = name => `${decimals(valueOf(name), 2)} cameras on average`;
    const none = name => `none in ${percent(1 - valueOf(name))}`;
    const visits = valueOf('visits');
    return [
      Number.isNaN(valueOf('mean-k'))
        ? 'in an obstacle'
        : `${mean('mean-k')}, ${none('covered')} of the steps`,
      ...(visits ? [`${visits} visits: ${mean('visits-mean-k')}, ${none('visits-covered')}`] : []),
    ];
  }
}
