// The list of a site's zones, with what each asks for and how much of it is met.
import {el} from './dom.js';
import {decimals} from './numbers.js';

export class ZoneList {
  constructor() {
    this.body = el('tbody');
    this.element = el(
      'table',
      {class: 'shares', hidden: true},
      el('caption', {}, 'what the cameras can see'),
      el(
        'thead',
        {},
        el('tr', {}, ...['zone', 'asks for', 'met'].map(name => el('th', {scope: 'col'}, name))),
      ),
      this.body,
    );
  }

  /** Shows records ShownZone, except those of which it is not yet known what is met. */
  show(zones) {
    const known = zones.filter(({met}) => met !== undefined);
    this.element.hidden = !known.length;
    this.body.replaceChildren(
      ...known.map(({name, demand, met}) =>
        el(
          'tr',
          {},
          el('th', {scope: 'row'}, name),
          el('td', {}, demand),
          el('td', {class: 'met'}, `${decimals(100 * met, 1)} %`),
        ),
      ),
    );
  }
}
