// The layers of zones and of their names, with the share of each zone that is met. Rhino runs this
// file too: see scene.js.
import {decimals} from './numbers.js';
import {ring} from './views.js';

const LINE_ZONE_WIDTH = 1; // metres
const DASHES = [7, 4];

/** Whether any of the zones has an outline; the whole field has none. */
export const hasOutlines = (zones = []) => zones.some(({points}) => points.length);

/** Draws the zones of a site that is being planned; runs show none. */
export function zones(context, {zones: shown, map, colours, unit}) {
  if (!shown) return;
  shown
    .filter(({points}) => points.length)
    .forEach(zone => {
      context.strokeStyle = context.fillStyle = colours.accent;
      context.beginPath();
      outline(context, zone, map);
      context.lineWidth = zone.shape === 'POLYLINE' ? LINE_ZONE_WIDTH * map.scale : 1.5 * unit;
      context.globalAlpha = 0.1;
      if (zone.shape === 'POLYLINE') context.stroke();
      else context.fill();
      context.globalAlpha = 1;
      context.setLineDash(DASHES.map(dash => dash * unit));
      context.lineWidth = 1.5 * unit;
      context.stroke();
      context.setLineDash([]);
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

/** Writes the names of zones above the views, each on a plate that no other plate covers. */
export function zoneNames(context, {zones: shown, map, colours, unit}) {
  if (!shown) return;
  const plates = [];
  context.font = `${12 * unit}px sans-serif`;
  shown
    .filter(({points}) => points.length)
    .forEach(({name, met, points, facing}) => {
      const text = met === undefined ? name : `${name} ${decimals(100 * met, 1)} %`;
      const plate = freePlate(plates, {
        x: middle(points.map(point => map.x(point.x))),
        y: middle(points.map(point => map.y(point.y))),
        width: context.measureText(text).width + 8 * unit,
        height: 17 * unit,
      });
      plates.push(plate);
      paintName(context, text, plate, colours, unit);
      if (facing !== undefined) arrow(context, plate.x, plate.y + 10 * unit, facing, colours, unit);
    });
}

const middle = list => (Math.min.apply(null, list) + Math.max.apply(null, list)) / 2;

/** The share of its height by which a plate may overlap another: allows for rounding errors. */
const OVERLAP = 0.01;

/** Moves a plate down until it covers no other one. */
function freePlate(plates, plate) {
  const covers = other =>
    Math.abs(other.x - plate.x) < (other.width + plate.width) / 2 &&
    Math.abs(other.y - plate.y) < plate.height * (1 - OVERLAP);
  const covered = plates.find(covers);
  if (!covered) return plate;
  return freePlate(plates, Object.assign({}, plate, {y: covered.y + plate.height}));
}

function paintName(context, text, {x, y, width, height}, colours, unit) {
  context.globalAlpha = 0.85;
  context.fillStyle = colours.paper;
  context.fillRect(x - width / 2, y - height / 2, width, height);
  context.globalAlpha = 1;
  context.fillStyle = colours.ink;
  context.textAlign = 'center';
  context.fillText(text, x, y + 4 * unit);
}

/** Draws an arrow in the direction in which the faces look that a zone asks for. */
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
