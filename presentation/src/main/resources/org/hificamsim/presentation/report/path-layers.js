// The layers of targets' paths: their whole tracks, or their last steps. Rhino runs this file too:
// see scene.js.
import {figureSize} from './figure-size.js';
import {COVER, coverClass} from './palette.js';

const TRAIL_FRAMES = 40;
const MOST_TRAIL_SEGMENTS = 1500;
const DOT_RADIUS = 2.2;

/** Paints the tracks by the scene's own function: see paintScene. */
export function tracks(context, scene) {
  if (!scene.tracks) return;
  context.globalAlpha = 0.5;
  scene.tracks(context);
}

/**
 * Draws the tracks of all targets from a frame on. A dot marks where a target appeared, and a line
 * leads from there to its last position.
 * @param every the number of frames that one segment of a line spans
 */
export function paintTracks(context, {run, map, colours, unit}, from, every = 1) {
  const radius = DOT_RADIUS * unit;
  context.strokeStyle = context.fillStyle = colours.ink;
  context.lineWidth = 0.9 * unit;
  run.setup.targets.forEach((target, i) => {
    const [present, x, y] = [run.present[i], run.x[i], run.y[i]];
    context.beginPath();
    for (let f = from; f < run.count; f++) {
      if (!present[f]) continue;
      let [px, py] = [map.x(x[f]), map.y(y[f])];
      if (!f || !present[f - 1]) {
        context.fillRect(px - radius, py - radius, 2 * radius, 2 * radius);
        context.moveTo(px, py);
      } else {
        if (f === from) context.moveTo(map.x(x[f - 1]), map.y(y[f - 1]));
        if (f % every === 0 || f + 1 === run.count || !present[f + 1]) context.lineTo(px, py);
      }
    }
    context.stroke();
  });
}

/** Draws the last steps of each target, with colours and widths by the number of cameras. */
export function trails(context, scene) {
  if (!scene.trails) return;
  const {run, frame, map} = scene;
  const size = figureSize(scene);
  const length = Math.ceil(Math.min(TRAIL_FRAMES, MOST_TRAIL_SEGMENTS / run.mostTargets));
  const first = Math.max(1, frame - length + 1);
  context.lineCap = 'round';
  for (let i = 0; i < run.setup.targets.length; i++) {
    let [present, x, y] = [run.present[i], run.x[i], run.y[i]];
    for (let f = first; f <= frame; f++) {
      let line =
        present[f] &&
        present[f - 1] &&
        nearbyPart(map, [map.x(x[f - 1]), map.y(y[f - 1])], [map.x(x[f]), map.y(y[f])]);
      if (!line) continue;
      let cover = COVER[coverClass(run.coverage[i][f])];
      context.globalAlpha = 0.15 + (0.75 * (f - first + 1)) / (frame - first + 1);
      context.strokeStyle = cover.colour;
      context.lineWidth = cover.width * size;
      context.beginPath();
      context.moveTo(line[0][0], line[0][1]);
      context.lineTo(line[1][0], line[1][1]);
      context.stroke();
    }
  }
}

/**
 * Returns the part of a line that is in or near the picture (Liang and Barsky 1984); null if there
 * is none. Painting takes time in proportion to a line's length, so the rest is left out.
 */
function nearbyPart({width, height}, a, b) {
  let [from, to] = [0, 1];
  [
    [0, width],
    [1, height],
  ].forEach(([axis, size]) => {
    const rise = b[axis] - a[axis];
    const ends = [-size, 2 * size].map(edge =>
      rise ? (edge - a[axis]) / rise : edge < a[axis] ? -Infinity : Infinity,
    );
    from = Math.max(from, Math.min(ends[0], ends[1]));
    to = Math.min(to, Math.max(ends[0], ends[1]));
  });
  return from < to
    ? [from, to].map(share => [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])])
    : null;
}
