// The cards of blind spots and zones on the page of a run.
import {el} from './dom.js';
import {spelled, tipped} from './names.js';
import {decimals, percent} from './numbers.js';
import {row, table} from './run-details.js';

const MOST_SPOTS = 5;

/** The card of areas that no camera ever covered; calls `show(spot)` for one that is clicked. */
export function blindSpotCard(heat, spots, show) {
  const centre = ({minX, maxX, minY, maxY}) =>
    `(${decimals((minX + maxX) / 2, 1)}, ${decimals((minY + maxY) / 2, 1)})`;
  const entry = spot => {
    const area = decimals(spot.area, spot.area < 10 ? 1 : 0);
    const text = `${area} m² around ${centre(spot)}`;
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
 * The card of zones: what each asks for, and how much of that is met.
 *
 * @param zones the zones of the setup
 * @param met the share of each zone that is seen as it asks, by the zone's name
 * @param shares how each zone was covered, from `zoneShares`; a false value without a heat map
 */
export function zoneCard(zones, met, shares, detection) {
  const cell = share => el('td', {}, Number.isNaN(share) ? '–' : percent(share));
  const card = table(
    'Zones',
    [
      'zone',
      'asks for',
      'met',
      ...(shares ? ['by one or more cameras', 'by two or more', 'never'] : []),
    ],
    zones.map((zone, i) =>
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
        el('td', {}, el('b', {}, zone.name in met ? percent(met[zone.name]) : '–')),
        ...(shares ? [shares[i].covered, shares[i].twice, shares[i].never].map(cell) : []),
      ),
    ),
  );
  card.className = 'card zones';
  card.append(el('p', {class: 'note'}, noteOn(zones, shares, detection)));
  return card;
}

const noteOn = (zones, shares, detection) =>
  'Met: the share of the zone’s area that is seen as the zone asks, in the mean of the steps, as ' +
  'place and view count it.' +
  (shares
    ? ` The others are by the run’s ${spelled(detection)} in the cells of the heat map` +
      (zones.some(({faces}) => faces) ? ', from wherever cameras look.' : '.')
    : '');
