// The layer of zones, with the share of each that is met. Rhino runs this file too: see scene.js.
import {decimals} from './numbers.js';
import {ring} from './views.js';

const STRIP = 1; // metres, the width of a zone along a line
const DASHES = [7, 4];

/** The zones of a site that is being planned; runs show none. */
export function zones(context, {zones: shown, map, colours, unit}) {
  if (!shown) return;
  shown
    .filter(({points}) => points.length)
    .forEach(zone => {
      context.strokeStyle = context.fillStyle = colours.accent;
      context.beginPath();
      outline(context, zone, map);
      context.lineWidth = zone.shape === 'POLYLINE' ? STRIP * map.scale : 1.5 * unit;
      context.globalAlpha = 0.1;
      if (zone.shape === 'POLYLINE') context.stroke();
      else context.fill();
      context.globalAlpha = 1;
      context.setLineDash(DASHES.map(dash => dash * unit));
      context.lineWidth = 1.5 * unit;
      context.stroke();
      context.setLineDash([]);
      label(context, zone, map, colours, unit);
    });
}

function outline(path, {shape, points}, map) {
  const [corner, opposite] = points;
  if (shape === 'RECTANGLE') {
    path.rect(
      map.x(corner.x),
      map.y(corner.y),
      map.scale * (opposite.x - corner.x),
      -map.scale * (opposite.y - corner.y),
    );
  } else if (shape === 'POLYGON') {
    ring(
      path,
      map,
      points.flatMap(({x, y}) => [x, y]),
    );
  } else {
    points.forEach(({x, y}, i) => path[i ? 'lineTo' : 'moveTo'](map.x(x), map.y(y)));
  }
}

function label(context, {name, met, points, facing}, map, colours, unit) {
  const text = met === undefined ? name : `${name} ${decimals(100 * met, 1)} %`;
  const middle = list => (Math.min.apply(null, list) + Math.max.apply(null, list)) / 2;
  const [x, y] = [
    middle(points.map(point => map.x(point.x))),
    middle(points.map(point => map.y(point.y))),
  ];
  context.font = `${12 * unit}px sans-serif`;
  context.textAlign = 'center';
  context.strokeStyle = colours.paper;
  context.lineWidth = 3 * unit;
  context.lineJoin = 'round';
  context.strokeText(text, x, y);
  context.fillStyle = colours.ink;
  context.fillText(text, x, y);
  if (facing !== undefined) arrow(context, x, y + 6 * unit, facing, colours, unit);
}

/** The direction in which faces look that have to be seen. */
function arrow(context, x, y, facing, colours, unit) {
  const heading = (facing * Math.PI) / 180;
  const [dx, dy] = [Math.sin(heading), -Math.cos(heading)];
  const point = (along, aside) => [
    x + unit * (along * dx - aside * dy),
    y + unit * (along * dy + aside * dx) + 8 * unit,
  ];
  context.strokeStyle = colours.accent;
  context.lineWidth = 2 * unit;
  context.beginPath();
  [point(-9, 0), point(9, 0), point(4, 4), point(9, 0), point(4, -4)].forEach(([px, py], i) =>
    context[i ? 'lineTo' : 'moveTo'](px, py),
  );
  context.stroke();
}
