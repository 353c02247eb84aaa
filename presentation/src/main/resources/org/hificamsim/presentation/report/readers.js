// One page in the order of one reader or another; the browser remembers who reads.
import {el} from './dom.js';

const KEY = 'hificamsim-reader';

/** What was remembered; a browser may refuse to. */
function remembered() {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

function remember(name) {
  try {
    localStorage.setItem(KEY, name);
  } catch {
    // the choice holds for this page alone
  }
}

export class Readers {
  /**
   * @param orders elements by the name of a reader, the first one's unless another was chosen
   */
  constructor(orders) {
    this.orders = orders;
    this.element = el('div', {class: 'parts'});
    this.select = el(
      'select',
      {id: 'reader', onchange: () => this.choose(this.select.value)},
      ...Object.keys(orders).map(name => el('option', {value: name}, name)),
    );
    this.control = el(
      'p',
      {class: 'chooser'},
      el('label', {for: 'reader'}, 'order for a '),
      this.select,
    );
    this.show(remembered() in orders ? remembered() : Object.keys(orders)[0]);
  }

  choose(name) {
    remember(name);
    this.show(name);
  }

  show(name) {
    this.select.value = name;
    this.element.replaceChildren(...this.orders[name].filter(Boolean));
  }
}
