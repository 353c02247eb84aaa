// What stands in the field besides cameras and targets: obstacles, their shadows, and a picture of the floor.
import { decimals, el } from './dom.js';
import { fillDetected, inSight, ring } from './views.js';

const WALL = 3; // pixels
const NEAR = 6;

/** What an obstacle is called. */
export const named = ({kind, transmittance}) => `${kind}, ${transmittance ? `lets ${decimals(100 * transmittance, 1)} % through` : 'solid'}`;

/** An obstacle and where it is. */
export function located(obstacle) {
  const at = (x, y) => `(${decimals(x)}, ${decimals(y)})`;
  const {kind, x1, y1, x2, y2, x, y, points} = obstacle;
  const place = kind === 'wall' ? `from ${at(x1, y1)} to ${at(x2, y2)}` : `at ${kind === 'pillar' ? at(x, y) : at(points[0].x, points[0].y)}`;
  return `${named(obstacle)}, ${place} m`;
}

export class Site {
  constructor(setup, changed) {
    this.obstacles = setup.obstacles ?? [];
    this.floor = (setup.floor ?? []).map(({area, data}) => ({area, image: el('img', {src: data, onload: changed})}));
    this.opacity = 0.5;
    this.layer = document.createElement('canvas');
  }

  /** Takes note of another map from metres to pixels. */
  fit(map, unit) {
    this.map = map;
    this.unit = unit;
    this.paths = this.obstacles.map(obstacle => outline(obstacle, map));
  }

  paintFloor(context) {
    const {map} = this;
    context.globalAlpha = this.opacity;
    for (const {area: {minX, maxX, minY, maxY}, image} of this.floor) {
      if (image.complete) context.drawImage(image, map.x(minX), map.y(maxY), map.scale * (maxX - minX), map.scale * (maxY - minY));
    }
    context.globalAlpha = 1;
  }

  /** Where some camera would detect, and walls hide it from all; `views` are those that cameras see through. */
  paintShadows(context, views, colour) {
    const cut = views.filter(({visible}) => visible);
    if (!cut.length) return;
    const {layer, map} = this;
    const {canvas} = context;
    [layer.width, layer.height] = [canvas.width, canvas.height];
    const shadows = layer.getContext('2d');
    shadows.setTransform(context.getTransform());
    shadows.fillStyle = shadows.createPattern(hatch(colour, this.unit), 'repeat');
    cut.forEach(view => fillDetected(shadows, map, view));
    shadows.globalCompositeOperation = 'destination-out';
    shadows.fillStyle = '#000';
    views.forEach(view => inSight(shadows, map, view, () => fillDetected(shadows, map, view)));
    context.save();
    context.resetTransform();
    context.drawImage(layer, 0, 0);
    context.restore();
  }

  paintObstacles(context, colour) {
    context.lineJoin = 'round';
    context.strokeStyle = colour;
    context.fillStyle = colour;
    this.obstacles.forEach(({kind, transmittance}, i) => {
      context.globalAlpha = transmittance ? 0.05 + 0.25 * (1 - transmittance) : 0.65;
      if (kind !== 'wall') context.fill(this.paths[i]);
      context.globalAlpha = 1;
      context.lineCap = transmittance ? 'butt' : 'round';
      context.setLineDash(transmittance ? [6 * this.unit, 3 * this.unit] : []);
      context.lineWidth = (kind === 'wall' ? WALL : 1) * this.unit;
      context.stroke(this.paths[i]);
    });
    context.setLineDash([]);
  }

  /** The obstacle at a place in pixels; -1 for none. */
  at(context, x, y) {
    context.save();
    context.resetTransform();
    context.lineWidth = 2 * NEAR * this.unit;
    const found = this.obstacles.findIndex(({kind}, i) => context.isPointInStroke(this.paths[i], x, y) ||
      (kind !== 'wall' && context.isPointInPath(this.paths[i], x, y)));
    context.restore();
    return found;
  }

  /** What the legend says of it: a class of the style sheet, and words. */
  legend(setup) {
    const through = [...new Set(this.obstacles.map(({transmittance}) => transmittance).filter(Boolean))].sort().slice(0, 3);
    const solid = this.obstacles.some(({transmittance}) => !transmittance);
    return [
      ...(solid ? [['key-wall', 'obstacle'], ['key-shadow', 'hidden from all by obstacles']] : []),
      ...through.map(part => ['key-through', `lets ${decimals(100 * part, 1)} % through`]),
      ...(setup.slow ? [['key-blind', 'moves, sees nothing']] : []),
    ];
  }
}

/** A tile of pale ground and a diagonal line, which shows on light and on dark floors. */
export function hatch(colour, unit) {
  const tile = document.createElement('canvas');
  const side = (tile.width = tile.height = Math.round(7 * unit));
  const context = tile.getContext('2d');
  context.fillStyle = context.strokeStyle = colour;
  context.globalAlpha = 0.22;
  context.fillRect(0, 0, side, side);
  context.globalAlpha = 0.7;
  context.beginPath();
  for (const from of [-side, 0, side]) {
    context.moveTo(from, side);
    context.lineTo(from + side, 0);
  }
  context.stroke();
  return tile;
}

function outline(obstacle, map) {
  const path = new Path2D();
  const {kind, x1, y1, x2, y2, x, y, radius, points} = obstacle;
  if (kind === 'wall') {
    path.moveTo(map.x(x1), map.y(y1));
    path.lineTo(map.x(x2), map.y(y2));
  } else if (kind === 'pillar') {
    path.arc(map.x(x), map.y(y), map.scale * radius, 0, 2 * Math.PI);
  } else {
    ring(path, map, points.flatMap(point => [point.x, point.y]));
  }
  return path;
}
