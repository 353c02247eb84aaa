// The cards of a run's page about areas: blind spots and zones.
import {el} from './dom.js';
import {spelled, tipped} from './names.js';
import {decimals, percent} from './numbers.js';
import {row, table} from './run-details.js';

const MOST_SPOTS = 5;

/** The areas that no camera ever covered; `show(spot)` is called for the one that is clicked. */
export function blindSpotCard(heat, spots, show) {
  const place = ({minX, maxX, minY, maxY}) =>
    `(${decimals((minX + maxX) / 2, 1)}, ${decimals((minY + maxY) / 2, 1)})`;
  const entry = spot => {
    const area = decimals(spot.area, spot.area < 10 ? 1 : 0);
    const text = `${area} m² around ${place(spot)}`;
    return el('li', {}, el('button', {type: 'button', onclick: () => show(spot)}, text));
  };
  const rest = `The largest ${MOST_SPOTS} of ${spots.length}; hatched on the heat map.`;
  return el(
    'section',
    {class: 'card blind-spots'},
    el('h2', {}, 'Blind spots'),
    el(
      'p',
      {},
      `Of the area ${percent(heat.areaCovered)} is covered by one or more cameras in the mean of ` +
        `the steps, ${percent(heat.areaCoveredK)} by two or more; ` +
        `${percent(heat.areaBlind)} never is.`,
    ),
    spots.length ? el('ol', {}, ...spots.slice(0, MOST_SPOTS).map(entry)) : null,
    spots.length > MOST_SPOTS ? el('p', {class: 'note'}, rest) : null,
  );
}

/**
 * The zones, what each demands, and how it was covered. The share by as many cameras as a zone
 * demands is bold.
 */
export function zoneCard(shares, detection) {
  const others = shares.some(({zone}) => zone.detection !== detection);
  const cell = (share, bold) =>
    el('td', {}, Number.isNaN(share) ? '–' : bold ? el('b', {}, percent(share)) : percent(share));
  const card = table(
    'Zones',
    ['zone', 'asks for', 'by one or more cameras', 'by two or more', 'never'],
    shares.map(({zone, covered, twice, never}) =>
      row(
        zone.name,
        zone.name,
        zone.name,
        el(
          'td',
          {},
          `${zone.k} camera${zone.k === 1 ? '' : 's'}, `,
          tipped(spelled(zone.detection), zone.detection),
          zone.faces ? ', of faces' : null,
        ),
        cell(covered, zone.k === 1 && !zone.faces),
        cell(twice, zone.k === 2 && !zone.faces),
        cell(never),
      ),
    ),
  );
  card.className = 'card zones';
  card.append(
    el(
      'p',
      {class: 'note'},
      'Shares of the zone’s area, in the mean of the steps',
      others
        ? `, all by the run’s ${spelled(detection)}: ` +
            'place --verify has them by what each zone asks for.'
        : '.',
      shares.some(({zone}) => zone.faces)
        ? ' From where faces are seen counts in zones_met, place --evaluate and view, not here.'
        : '',
    ),
  );
  return card;
}
