// The order of a page's parts for different readers; the browser remembers the choice.
import {el} from './dom.js';

const KEY = 'hificamsim-reader';

/** Returns the remembered reader; null if there is none or the browser refuses. */
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
    // the choice is for this page alone
  }
}

export class Readers {
  /**
   * @param orders lists of elements by the name of the reader; the first is the default
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
