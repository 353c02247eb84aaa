// The form of walls, which are drawn with the mouse or typed, and removed.
import {el} from './dom.js';
import {located} from './site.js';
import {decimals} from './numbers.js';

const ENDS = ['x1', 'y1', 'x2', 'y2'];

export class WallForm {
  /**
   * @param edit `wall(x1, y1, x2, y2)` in metres, `removeObstacle(obstacle)`
   * @param onDrawing is called with whether pressing in the field begins a wall
   */
  constructor({obstacles = []}, edit, onDrawing) {
    this.onDrawing = onDrawing;
    this.edit = edit;
    this.inputs = ENDS.map(name =>
      el('input', {type: 'number', step: 'any', name, required: true}),
    );
    this.draw = el(
      'button',
      {
        type: 'button',
        class: 'draw',
        'aria-pressed': 'false',
        onclick: () => this.setDrawing(this.draw.getAttribute('aria-pressed') !== 'true'),
      },
      'draw with the mouse',
    );
    this.list = el(
      'select',
      {name: 'obstacle', 'aria-label': 'obstacle to remove'},
      ...obstacles.map((obstacle, i) => el('option', {value: i}, located(obstacle))),
    );
    const add = el(
      'form',
      {onsubmit: event => this.add(event)},
      ...this.inputs.map((input, i) => el('label', {}, `${ENDS[i]} `, input)),
      el('button', {class: 'add-wall'}, 'add a wall'),
    );
    const removal = obstacles.length
      ? el(
          'p',
          {},
          this.list,
          el(
            'button',
            {
              type: 'button',
              class: 'remove',
              onclick: () => edit.removeObstacle(Number(this.list.value)),
            },
            'remove',
          ),
        )
      : null;
    this.element = el(
      'details',
      {class: 'pose walls', open: obstacles.length > 0},
      el('summary', {}, 'walls'),
      this.draw,
      add,
      removal,
    );
  }

  setDrawing(on) {
    this.draw.setAttribute('aria-pressed', String(on));
    this.onDrawing(on);
  }

  add(event) {
    event.preventDefault();
    this.edit.wall(...this.inputs.map(({value}) => Number(value)));
  }

  /** Shows the ends of a wall that is being drawn. */
  show(ends) {
    this.inputs.forEach((input, i) => (input.value = decimals(ends[i], 3)));
  }
}
