// Describes obstacles, and finds the one under the pointer.
import {decimals} from './numbers.js';
import {outline} from './obstacle-layer.js';

const NEAR = 6; // pixels

/** The kind of an obstacle and how much light it lets through. */
export const describeObstacle = ({kind, transmittance}) =>
  `${kind}, ${transmittance ? `lets ${decimals(100 * transmittance, 1)} % through` : 'solid'}`;

/** The same, with the obstacle's position in metres. */
export function describeWithPosition(obstacle) {
  const point = (x, y) => `(${decimals(x)}, ${decimals(y)})`;
  const {kind, x1, y1, x2, y2, x, y, points} = obstacle;
  const position =
    kind === 'wall'
      ? `from ${point(x1, y1)} to ${point(x2, y2)}`
      : `at ${kind === 'pillar' ? point(x, y) : point(points[0].x, points[0].y)}`;
  return `${describeObstacle(obstacle)}, ${position} m`;
}

/** Returns the obstacle at or near a point, in pixels; undefined if there is none. */
export function obstacleAt(context, obstacles, map, unit, [x, y]) {
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
