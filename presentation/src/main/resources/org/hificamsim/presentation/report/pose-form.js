// The form that moves and turns the selected camera, and that adds and removes cameras.
import {el} from './dom.js';
import {decimals} from './numbers.js';

/** Converts a heading in radians to degrees, from 0 to 360. */
export const degrees = heading => rounded(((((heading * 180) / Math.PI) % 360) + 360) % 360);

/** Rounds to a thousandth: metres to millimetres. */
export const rounded = number => Math.round(number * 1000) / 1000;

export class PoseForm {
  /**
   * @param edit functions that are called: `move(camera, x, y)` in metres, `turn(camera, degrees)`,
   *   `add(camera)` to copy a camera, `removeCamera(camera)`, and `suggest(camera)` to move a
   *   camera to a better place, or to add one for -1
   */
  constructor(edit) {
    this.x = field('x', 'm', () => this.move());
    this.y = field('y', 'm', () => this.move());
    this.heading = field(
      'heading',
      '°',
      () => this.isNumber(this.heading) && edit.turn(this.camera, Number(this.heading.value)),
    );
    this.edit = edit;
    this.element = el(
      'div',
      {class: 'pose', role: 'group', 'aria-label': 'the chosen camera’s place and heading'},
      ...[this.x, this.y, this.heading].map(input => input.label),
      el(
        'button',
        {type: 'button', class: 'add', onclick: () => edit.add(this.camera)},
        'add a camera like it',
      ),
      el(
        'button',
        {type: 'button', class: 'remove-camera', onclick: () => edit.removeCamera(this.camera)},
        'remove it',
      ),
      el(
        'button',
        {type: 'button', class: 'suggest', onclick: () => edit.suggest(-1)},
        'suggest a camera',
      ),
      el(
        'button',
        {type: 'button', class: 'suggest-place', onclick: () => edit.suggest(this.camera)},
        'suggest a better place for it',
      ),
    );
  }

  move() {
    if (this.isNumber(this.x) && this.isNumber(this.y))
      this.edit.move(this.camera, Number(this.x.value), Number(this.y.value));
  }

  isNumber(input) {
    return input.value.trim() !== '' && Number.isFinite(Number(input.value));
  }

  /** Shows a camera's pose, except in the input that the user is typing in. */
  show(camera, pose) {
    const values = [
      [this.x, pose.x],
      [this.y, pose.y],
      [this.heading, degrees(pose.heading)],
    ];
    for (const [input, value] of values) {
      if (input !== document.activeElement || camera !== this.camera)
        input.value = decimals(value, 3);
    }
    this.camera = camera;
  }
}

function field(name, unit, onchange) {
  const input = el('input', {type: 'number', step: 'any', name, onchange});
  input.label = el('label', {}, `${name} `, input, ` ${unit}`);
  return input;
}
