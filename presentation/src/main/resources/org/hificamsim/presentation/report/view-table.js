// The table of the views of a camera that can turn: a row for each zoom level, a column for each
// pan angle and tilt.
import {el, setText} from './dom.js';
import {decimals} from './numbers.js';
import {directionName, viewName} from './views.js';

export class ViewTable {
  /**
   * @param pose the camera's pose
   * @param hold is called with a view in which the camera is to stay; undefined if views cannot be
   *   chosen
   */
  constructor(pose, hold) {
    const {levels, pans} = pose;
    this.cells = pans.flatMap((pan, i) =>
      levels.map((level, zoom) =>
        cell(i * levels.length + zoom, viewName(pose, i * levels.length + zoom), hold),
      ),
    );
    const rows = levels.map((level, zoom) =>
      el(
        'tr',
        {},
        el('th', {scope: 'row'}, String(zoom)),
        ...pans.map((pan, i) => this.cells[i * levels.length + zoom].element),
      ),
    );
    this.element = el(
      'div',
      {
        class: 'views',
        tabindex: 0,
        role: 'group',
        'aria-label': 'views: zoom levels by pan angles',
      },
      el(
        'table',
        {},
        el(
          'thead',
          {},
          el(
            'tr',
            {},
            el('th', {scope: 'col'}, 'level'),
            ...pans.map((pan, i) => el('th', {scope: 'col'}, directionName(pose, i))),
          ),
        ),
        el('tbody', {}, ...rows.reverse()),
      ),
    );
  }

  /**
   * Shows the chosen view and the estimates.
   * @param chosen the view that was chosen, -1 for none
   * @param blind whether the camera is still turning to it
   * @param estimates the estimate of each view; null if there are none
   * @param counts the number of observations of each estimate; null if there are none
   */
  show(chosen, blind, estimates, counts) {
    const largest = Math.max(1e-12, ...(estimates ?? []).filter(Number.isFinite).map(Math.abs));
    this.cells.forEach(({element, bar, text, button}, i) => {
      const value = estimates?.[i];
      const known = Number.isFinite(value);
      element.classList.toggle('now', i === chosen);
      element.classList.toggle('blind', i === chosen && blind);
      if (i === chosen) element.setAttribute('aria-current', 'true');
      else element.removeAttribute('aria-current');
      bar.style.transform = `scaleX(${known ? Math.abs(value) / largest : 0})`;
      bar.classList.toggle('negative', known && value < 0);
      setText(text, known ? threeDigits(value) : i === chosen ? (blind ? '○' : '●') : '·');
      const count = counts?.[i];
      const estimate = known ? `: ${decimals(value, 4)}` : '';
      const used = Number.isFinite(count) ? `, used ${count} times` : '';
      element.title = `${element.dataset.named}${estimate}${used}`;
      button?.setAttribute('aria-label', `hold ${element.title}`);
    });
  }
}

const threeDigits = value => String(Number(value.toPrecision(3)));

function cell(view, named, hold) {
  const bar = el('i', {class: 'bar'});
  const text = el('span');
  const button = hold && el('button', {type: 'button', onclick: () => hold(view)}, text);
  return {bar, text, button, element: el('td', {data: {view, named}}, bar, button || text)};
}
