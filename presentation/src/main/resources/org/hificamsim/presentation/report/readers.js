// Orders a page's parts for different readers. The browser remembers the chosen reader.
import {el} from './dom.js';

const KEY = 'hificamsim-reader';

/** Returns the name of the remembered reader; null if there is none or storage is blocked. */
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
    // Storage is blocked: the choice holds for this page only.
  }
}

export class Readers {
  /**
   * @param orders an object of lists of elements, by reader; the first reader is the default
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
