// How each cell of the field was covered: one figure at a time, in colours, over the field.
import { el, decimals, percent } from './dom.js';
import { COVER, levelColour } from './palette.js';
import { inflate } from './inflate.js';
import { optional, SeriesReader } from './recording.js';
import { hatch } from './site.js';

const STRENGTH = 0.8;
const NEVER = COVER[0].colour; // hatched: what no camera ever covers, as a target that none does
const FIGURES = [
  {name: 'mean-k', label: 'cameras that would detect there, mean', unit: 'cameras', never: 'no camera, at no step', of: (heat, cell) => heat.meanK[cell]},
  {name: 'covered', label: 'steps with 1 or more cameras', unit: 'share', never: 'no camera, at no step', of: (heat, cell) => 1 - heat.covered0[cell]},
  {name: 'covered-k', label: 'steps with 2 or more cameras', unit: 'share', never: 'never 2 cameras', of: (heat, cell) => heat.coveredK[cell]},
  {name: 'visits', label: 'targets there, added up over the steps', unit: 'count', of: (heat, cell) => heat.visits[cell] || NaN},
  {name: 'visits-mean-k', label: 'cameras that detected a target there, mean', unit: 'cameras', never: 'no camera, at no visit', of: (heat, cell) => heat.visitsMeanK[cell]},
  {name: 'visits-covered', label: 'visits with 1 or more cameras', unit: 'share', never: 'no camera, at no visit', of: (heat, cell) => 1 - heat.visitsCovered0[cell]},
];
const SERIES = ['meanK', 'covered0', 'coveredK', 'visits', 'visitsMeanK', 'visitsCovered0'];

/** The heat map that the record PackedHeat holds. */
export async function unpackHeat(packed) {
  const reader = new SeriesReader(await inflate(packed.data));
  const heat = {...packed, cells: packed.columns * packed.rows};
  SERIES.forEach(name => (heat[name] = reader.series(heat.cells, optional(packed.perUnit))));
  return heat;
}

export class HeatLayer {
  /**
   * @param chosen is called with a figure's name, or with '' for none
   */
  constructor(setup, chosen) {
    this.field = setup.field;
    this.select = el('select', {name: 'heat', onchange: () => chosen(this.select.value)},
      el('option', {value: ''}, 'none'), ...FIGURES.map(({name, label}) => el('option', {value: name}, label)));
    this.key = el('span', {class: 'heat-key', hidden: true});
    this.cells = document.createElement('canvas');
  }

  /** Whether it covers the field. */
  get shown() {
    return Boolean(this.figure && this.heat);
  }

  /** Takes another map. */
  load(heat) {
    this.heat = heat;
    this.draw();
  }

  /** Takes another figure by its name; '' for none. */
  choose(name) {
    this.select.value = name;
    this.figure = FIGURES.find(figure => figure.name === name);
    this.draw();
  }

  draw() {
    this.key.hidden = !this.figure;
    if (!this.figure) return;
    if (!this.heat) return void this.key.replaceChildren('from the next step on');
    this.measure();
    this.drawCells();
    this.key.replaceChildren(...this.legend());
  }

  measure() {
    const {heat, figure} = this;
    this.values = Array.from({length: heat.cells}, (none, cell) => figure.of(heat, cell));
    const most = this.values.reduce((high, value) => (value > high ? value : high), 0);
    this.end = figure.unit === 'share' ? 1 : Math.max(1, Math.ceil(most));
  }

  share(value) {
    if (this.figure.unit === 'count') return this.end > 1 ? Math.log(value) / Math.log(this.end) : 1;
    return value / this.end;
  }

  drawCells() {
    const {columns, rows} = this.heat;
    [this.cells.width, this.cells.height] = [columns, rows];
    const context = this.cells.getContext('2d');
    const image = context.createImageData(columns, rows);
    this.values.forEach((value, cell) => {
      if (!(value > 0)) return;
      const row = rows - 1 - Math.floor(cell / columns);
      image.data.set([...levelColour(this.share(value)), 255], 4 * (row * columns + (cell % columns)));
    });
    context.putImageData(image, 0, 0);
  }

  paint(context, map, unit) {
    if (!this.shown) return;
    const {minX, maxX, minY, maxY} = this.field;
    if (this.values.includes(0)) this.paintNever(context, map, unit);
    context.save();
    context.globalAlpha = STRENGTH;
    context.imageSmoothingEnabled = false;
    context.drawImage(this.cells, map.x(minX), map.y(maxY), map.scale * (maxX - minX), map.scale * (maxY - minY));
    context.restore();
  }

  paintNever(context, map, unit) {
    const {columns, rows} = this.heat;
    const {minX, maxX, minY, maxY} = this.field;
    const [left, bottom, width, height] = [map.x(minX), map.y(minY), (map.scale * (maxX - minX)) / columns, (map.scale * (maxY - minY)) / rows];
    context.fillStyle = context.createPattern(hatch(NEVER, unit), 'repeat');
    context.beginPath();
    this.values.forEach((value, cell) => {
      if (value === 0) context.rect(left + (cell % columns) * width, bottom - (1 + Math.floor(cell / columns)) * height, width, height);
    });
    context.fill();
  }

  /** The scale from end to end, what has a colour of its own, and what the map is of. */
  legend() {
    const {heat, figure, end} = this;
    const [least, most] = figure.unit === 'share' ? ['0 %', '100 %'] : [figure.unit === 'count' ? '1' : '0', String(end)];
    const colours = Array.from({length: 9}, (none, i) => `rgb(${levelColour(i / 8).join(' ')})`);
    const bar = el('i', {class: 'heat-bar', role: 'img', 'aria-label': `from ${least}, dark, to ${most}, light`});
    bar.style.background = `linear-gradient(to right, ${colours.join(', ')})`;
    const never = el('i', {class: 'heat-never'});
    return [el('span', {}, least, bar, most), ...(this.values.includes(0) ? [el('span', {}, never, figure.never)] : []),
      el('span', {class: 'heat-steps'}, `${heat.first ? `${heat.steps} steps from ${heat.first} on` : `${heat.steps} step${heat.steps === 1 ? '' : 's'}`}: ${this.summary()}`)];
  }

  summary() {
    const {areaCovered, areaCoveredK, areaBlind} = this.heat;
    return `of area and steps ${percent(areaCovered)} with 1 or more cameras, ${percent(areaCoveredK)} with 2 or more; of the area ${percent(areaBlind)} never`;
  }

  /** What is told of a place in metres. */
  told(x, y) {
    const {minX, maxX, minY, maxY} = this.field;
    if (!this.shown || x < minX || x > maxX || y < minY || y > maxY) return [];
    const {heat} = this;
    const at = (place, from, to, count) => (to > from ? Math.min(count - 1, Math.floor(((place - from) / (to - from)) * count)) : 0);
    const cell = at(y, minY, maxY, heat.rows) * heat.columns + at(x, minX, maxX, heat.columns);
    return [
      Number.isNaN(heat.meanK[cell]) ? 'in an obstacle' : `${decimals(heat.meanK[cell], 2)} cameras in the mean, none in ${percent(heat.covered0[cell])} of the steps`,
      ...(heat.visits[cell] ? [`${heat.visits[cell]} visits: ${decimals(heat.visitsMeanK[cell], 2)} cameras in the mean, none in ${percent(heat.visitsCovered0[cell])}`] : []),
    ];
  }
}
