// Elements that several pages use: cards with a title, the command that made the page, SVG.
import {el} from './dom.js';

export const card = (title, ...children) =>
  el('section', {class: 'card'}, el('h2', {}, title), ...children);

/** A box that scrolls if its content is wider than the page; screen readers read its label. */
export const scrollBox = (label, ...children) =>
  el('div', {class: 'scroll', tabindex: 0, role: 'region', 'aria-label': label}, ...children);

/** A card with the command that made the page, and the version. */
export const madeWith = ({command, version}) =>
  card(
    'Made with',
    el('pre', {tabindex: 0}, command),
    el('p', {class: 'note'}, `HiFi-CamSim ${version}`),
  );

/** A folded card, whose content is built when it is first opened. */
export function foldedCard(title, build) {
  const details = el(
    'details',
    {class: 'card', ontoggle: () => details.childElementCount === 1 && details.append(build())},
    el('summary', {}, title),
  );
  return details;
}

/** A selection whose property `label` is its label; `nameOf` returns the text of a value. */
export function labelledSelect(name, values, chosen, onchange, nameOf = value => value) {
  const select = el(
    'select',
    {onchange, name, 'aria-label': name},
    ...values.map(value => el('option', {value, title: value}, nameOf(value))),
  );
  select.value = chosen;
  select.label = el('label', {}, `${name} `, select);
  return select;
}

/** Returns an SVG element. Attributes that start with "on" are listeners. */
export function svg(tag, attributes, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}
