// Magnifies and moves the map of a field by buttons, keys and the mouse wheel.
import {el} from './dom.js';
import {magnified} from './map.js';

const ZOOM_FACTOR = 1.5;
const GREATEST_MAGNIFICATION = 64;
const ARROWS = {ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};

export class Magnifier {
  /**
   * @param surface the Surface of the field
   * @param onChange is called when the map has changed
   */
  constructor(surface, onChange) {
    this.surface = surface;
    this.onChange = onChange;
    [this.times, this.left, this.top] = [1, 0, 0];
    this.showAll = button('⤢', 'show the whole field', () => this.showWhole());
    this.showAll.disabled = true;
    this.element = el(
      'div',
      {class: 'lens', role: 'group', 'aria-label': 'magnify'},
      button('+', 'zoom in', () => this.magnifyMiddle(ZOOM_FACTOR)),
      button('−', 'zoom out', () => this.magnifyMiddle(1 / ZOOM_FACTOR)),
      this.showAll,
    );
    surface.canvas.addEventListener('wheel', event => this.onWheel(event), {passive: false});
    surface.canvas.addEventListener('keydown', event => this.onKey(event));
  }

  /** Sets the map that shows the whole field, after the surface has changed its size. */
  setWholeMap(map) {
    this.whole = map;
    this.updateMap();
  }

  updateMap() {
    const {times, left, top, whole} = this;
    this.map = times === 1 ? whole : magnified(whole, times, left, top);
  }

  magnifyMiddle(factor) {
    this.magnify(factor, this.surface.width / 2, this.surface.height / 2);
  }

  /** Magnifies the map by a factor about a point, in pixels, which keeps its position. */
  magnify(factor, x, y) {
    const {times, left, top} = this;
    const next = Math.min(GREATEST_MAGNIFICATION, Math.max(1, times * factor));
    this.look(next, x - ((x - left) * next) / times, y - ((y - top) * next) / times);
  }

  /**
   * Sets the magnification and the offset in pixels, but moves no farther than the field's edges.
   */
  look(times, left, top) {
    if (!this.whole) return;
    const {width, height} = this.surface;
    const bounded = (offset, size) => Math.max(size * (1 - times), Math.min(0, offset));
    [this.times, this.left, this.top] = [times, bounded(left, width), bounded(top, height)];
    this.showAll.disabled = times === 1;
    this.updateMap();
    this.onChange();
  }

  showWhole() {
    this.look(1, 0, 0);
  }

  /** Shows an area, given in metres, with some of its surroundings. */
  showArea({minX, maxX, minY, maxY}) {
    const {width, height} = this.surface;
    const map = this.whole;
    const across = width / Math.max(1, map.x(maxX) - map.x(minX));
    const down = height / Math.max(1, map.y(minY) - map.y(maxY));
    const times = Math.min(GREATEST_MAGNIFICATION, Math.max(1, 0.4 * Math.min(across, down)));
    this.look(
      times,
      width / 2 - (times * (map.x(minX) + map.x(maxX))) / 2,
      height / 2 - (times * (map.y(minY) + map.y(maxY))) / 2,
    );
  }

  /** Handles +, - and 0, and the arrow keys if the map is magnified. */
  onKey(event) {
    const {times, left, top} = this;
    const {width, height} = this.surface;
    const arrow = ARROWS[event.key];
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (arrow && times > 1)
      this.look(times, left + (arrow[0] * width) / 8, top + (arrow[1] * height) / 8);
    else if ('+='.includes(event.key)) this.magnifyMiddle(ZOOM_FACTOR);
    else if (event.key === '-') this.magnifyMiddle(1 / ZOOM_FACTOR);
    else if (event.key === '0') this.showWhole();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** Magnifies by the wheel. If the whole field is shown, turning it down scrolls the page. */
  onWheel(event) {
    if (event.deltaY > 0 && this.times === 1) return;
    event.preventDefault();
    this.magnify(Math.exp(-event.deltaY / 400), event.offsetX, event.offsetY);
  }
}

const button = (text, label, onclick) =>
  el('button', {type: 'button', 'aria-label': label, title: label, onclick}, text);
