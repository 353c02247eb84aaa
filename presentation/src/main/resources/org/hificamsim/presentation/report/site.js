// Obstacles in words, and the one at a place.
import {outline} from './scene.js';
import {decimals} from './numbers.js';

const NEAR = 6; // pixels

/** What an obstacle is called. */
export const named = ({kind, transmittance}) =>
  `${kind}, ${transmittance ? `lets ${decimals(100 * transmittance, 1)} % through` : 'solid'}`;

/** An obstacle and where it is. */
export function located(obstacle) {
  const at = (x, y) => `(${decimals(x)}, ${decimals(y)})`;
  const {kind, x1, y1, x2, y2, x, y, points} = obstacle;
  const place =
    kind === 'wall'
      ? `from ${at(x1, y1)} to ${at(x2, y2)}`
      : `at ${kind === 'pillar' ? at(x, y) : at(points[0].x, points[0].y)}`;
  return `${named(obstacle)}, ${place} m`;
}

/** The obstacle at a place in pixels, if there is one. */
export function obstacleAt(context, obstacles, map, unit, x, y) {
  context.save();
  context.resetTransform();
  context.lineWidth = 2 * NEAR * unit;
  const found = obstacles.find(obstacle => {
    context.beginPath();
    outline(context, obstacle, map);
    return (
      context.isPointInStroke(x, y) || (obstacle.kind !== 'wall' && context.isPointInPath(x, y))
    );
  });
  context.restore();
  return found;
}
