// The layer of walls, polygons and pillars. Rhino runs this file too: see scene.js.
import {scaledDashes} from './dashes.js';
import {figureSize} from './figure-size.js';
import {ring} from './views.js';

const WALL_WIDTH = 3;
const TRANSPARENT_DASHES = [6, 3];

/** Draws all obstacles of the field. */
export function obstacles(context, scene) {
  const {run, map, colours, unit} = scene;
  const thick = Math.max(unit / 2, figureSize(scene));
  (run.setup.obstacles ?? []).forEach(obstacle => {
    context.beginPath();
    outline(context, obstacle, map);
    paintObstacle(context, obstacle, colours.wall, thick);
  });
}

/** Adds an obstacle's outline to the path. */
export function outline(path, {kind, x1, y1, x2, y2, x, y, radius, points}, map) {
  if (kind === 'wall') {
    path.moveTo(map.x(x1), map.y(y1));
    path.lineTo(map.x(x2), map.y(y2));
  } else if (kind === 'pillar') {
    path.moveTo(map.x(x + radius), map.y(y));
    path.arc(map.x(x), map.y(y), map.scale * radius, 0, 2 * Math.PI);
  } else {
    ring(
      path,
      map,
      points.flatMap(point => [point.x, point.y]),
    );
  }
}

/**
 * Paints the obstacle whose outline is the current path. One that lets light through is paler and
 * dashed.
 */
export function paintObstacle(context, {kind, transmittance}, colour, unit) {
  context.fillStyle = context.strokeStyle = colour;
  context.globalAlpha = transmittance ? 0.05 + 0.25 * (1 - transmittance) : 0.65;
  if (kind !== 'wall') context.fill();
  context.globalAlpha = 1;
  context.lineJoin = 'round';
  context.lineCap = transmittance ? 'butt' : 'round';
  context.setLineDash(transmittance ? scaledDashes(TRANSPARENT_DASHES, unit) : []);
  context.lineWidth = (kind === 'wall' ? WALL_WIDTH : 1) * unit;
  context.stroke();
}
