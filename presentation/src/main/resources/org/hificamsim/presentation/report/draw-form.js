// The form of the tools that draw walls, shelves, pillars, zones and cameras, and that remove them.
import {drawingTools} from './drawing-tools.js';
import {el} from './dom.js';
import {decimals} from './numbers.js';
import {rounded} from './pose-form.js';
import {describeWithPosition} from './site.js';

const ENDS = ['x1', 'y1', 'x2', 'y2'];

export class DrawForm {
  /**
   * @param data the data of the page, written by LivePage
   * @param edit `draw(tool, ends)` in metres, `removeObstacle(obstacle)`,
   *   `removeZone(zone, name)`
   * @param onOutline is called with the outline that a press in the field begins; '' for none
   */
  constructor(data, edit, onOutline) {
    this.edit = edit;
    this.onOutline = onOutline;
    this.tools = drawingTools(data);
    this.endInputs = ENDS.map(name =>
      el('input', {type: 'number', step: 'any', name, required: true}),
    );
    this.choice = el(
      'select',
      {name: 'tool', 'aria-label': 'what is drawn', onchange: () => this.choose()},
      ...this.tools.map(({name}) => el('option', {value: name}, name)),
    );
    this.inputs = el('span', {class: 'tool'});
    this.draw = el(
      'button',
      {
        type: 'button',
        class: 'draw',
        'aria-pressed': String(data.tools.plan),
        onclick: () => this.setDrawing(!this.isDrawing),
      },
      'draw with the mouse',
    );
    this.list = el('select', {name: 'drawn', 'aria-label': 'what is removed'});
    this.removal = el(
      'p',
      {hidden: true},
      this.list,
      el('button', {type: 'button', class: 'remove', onclick: () => this.remove()}, 'remove'),
    );
    this.element = el(
      'details',
      {class: 'pose drawing', open: data.tools.plan},
      el('summary', {}, 'draw'),
      el(
        'form',
        {onsubmit: event => this.add(event)},
        this.choice,
        this.draw,
        this.inputs,
        el(
          'span',
          {class: 'ends'},
          ...this.endInputs.slice(0, 2).map((input, i) => el('label', {}, `${ENDS[i]} `, input)),
          el('span'),
          ...this.endInputs.slice(2).map((input, i) => el('label', {}, `${ENDS[i + 2]} `, input)),
          el('span', {}, el('button', {class: 'add-drawn'}, 'add')),
        ),
      ),
      this.removal,
    );
    const first = data.tools.scaled ? 'wall' : 'scale';
    this.choice.value = first;
    this.choose();
  }

  get tool() {
    return this.tools.find(({name}) => name === this.choice.value);
  }

  get isDrawing() {
    return this.draw.getAttribute('aria-pressed') === 'true';
  }

  /** The outline that a press in the field begins; '' for none. */
  get outline() {
    return this.isDrawing ? this.tool.outline : '';
  }

  /** Shows the inputs of the chosen tool. */
  choose() {
    this.inputs.replaceChildren(
      ...this.tool.inputs.map(({label, input}) => el('label', {}, `${label} `, input)),
    );
    this.onOutline(this.outline);
  }

  setDrawing(isDrawing) {
    this.draw.setAttribute('aria-pressed', String(isDrawing));
    this.onOutline(this.outline);
  }

  add(event) {
    event.preventDefault();
    this.edit.draw(
      this.tool,
      this.endInputs.map(({value}) => rounded(Number(value))),
    );
  }

  /** Shows both ends of the outline that is being drawn, in metres. */
  show(ends) {
    this.endInputs.forEach((input, i) => (input.value = decimals(ends[i], 3)));
  }

  /** Draws an outline between two ends, unless the tool first asks for a number. */
  complete(ends) {
    this.show(ends);
    const {focusedInput} = this.tool;
    if (focusedInput) focusedInput.focus();
    else this.edit.draw(this.tool, ends.map(rounded));
  }

  /** Lists the obstacles and zones that can be removed. */
  listDrawn(obstacles, zones) {
    const removals = [
      ...obstacles.map((obstacle, i) => [
        describeWithPosition(obstacle),
        () => this.edit.removeObstacle(i),
      ]),
      ...zones.map(({name}, i) => [`zone ${name}`, () => this.edit.removeZone(i, name)]),
    ];
    const texts = removals.map(([text]) => text);
    this.removals = removals.map(([, remove]) => remove);
    this.removal.hidden = !removals.length;
    if (texts.join() === this.listed) return; // somebody may be choosing
    this.listed = texts.join();
    this.list.replaceChildren(...texts.map((text, i) => el('option', {value: i}, text)));
  }

  remove() {
    this.removals[Number(this.list.value)]?.();
  }
}
