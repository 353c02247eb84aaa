// How many pixels of a camera's picture a metre takes: the zones of EN 62676-4:2014, nearest first.
// Pale is far: one shade differs from the next for every eye.
import { inSight, sector } from './views.js';

export const ZONES = [
  {name: 'identify', least: 250, colour: '#56204a'},
  {name: 'recognise', least: 125, colour: '#96487a'},
  {name: 'observe', least: 62.5, colour: '#cc79a7'},
  {name: 'detect', least: 25, colour: '#e7b7d3'},
];

/** Paints the zones of a view, each with its name where it ends. */
export function paintZones(context, map, view, {ink, paper}, unit) {
  inSight(context, map, view, () => {
    let from = 0;
    for (const {least, colour} of ZONES) {
      const to = view.density / least;
      context.beginPath();
      sector(context, map, view, to);
      if (from) sector(context, map, view, from);
      context.fillStyle = colour;
      context.globalAlpha = 0.6;
      context.fill('evenodd');
      context.globalAlpha = 1;
      from = to;
    }
  });
  context.fillStyle = ink;
  context.strokeStyle = paper;
  context.lineWidth = 3 * unit;
  context.lineJoin = 'round';
  context.font = `${11 * unit}px sans-serif`;
  context.textAlign = 'center';
  for (const {name, least} of ZONES) {
    const far = view.density / least;
    const label = [`${name} ${least}`, map.x(view.x + far * Math.sin(view.heading)), map.y(view.y + far * Math.cos(view.heading))];
    context.strokeText(...label);
    context.fillText(...label);
  }
}

/** The density at a place in a view, pixels per metre; NaN where it is not in the picture or not known. */
export function densityAt(view, x, y) {
  const [right, up] = [x - view.x, y - view.y];
  const off = Math.atan2(right, up) - view.heading;
  const away = Math.abs(off - 2 * Math.PI * Math.round(off / (2 * Math.PI)));
  return view.density && away <= view.viewingAngle / 2 ? view.density / Math.hypot(right, up) : NaN;
}

/** What may be done at a density. */
export const zoneAt = density => ZONES.find(({least}) => density >= least)?.name ?? 'less than detect';
