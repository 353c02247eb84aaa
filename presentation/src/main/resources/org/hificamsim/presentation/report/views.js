// The views of cameras: a zoom level at a pan angle, cut off by walls. Rhino runs this file too:
// see scene.js.
import {signedDegrees} from './numbers.js';
import {DENSITY_ZONES} from './palette.js';

/** The number of views that a camera in this pose can choose. */
export const viewCount = ({levels, pans}) => levels.length * (pans?.length || 1);

/** Whether each camera has only one view, as in a plan, so that no policy can change anything. */
export const isStill = ({cameras}) => cameras.every(({pose}) => viewCount(pose) === 1);

/** Returns the properties of a camera's view; angles in radians, lengths in metres. */
export function viewOf(pose, view) {
  const zoom = view % pose.levels.length;
  const pan = pose.pans?.[Math.floor(view / pose.levels.length)] ?? 0;
  const lens = pose.lenses?.[zoom];
  const level = pose.levels[zoom];
  const detected = level.detected.reduce((most, {to}) => Math.max(most, to), 0);
  return {
    zoom,
    pan,
    level,
    x: pose.x,
    y: pose.y,
    visible: pose.visible,
    heading: pose.heading + pan,
    viewingAngle: lens?.viewingAngle ?? pose.viewingAngle,
    density: lens?.density ?? 0,
    ground: pose.grounds?.[view % pose.grounds.length], // in the picture, if cameras have a height
    reach: lens && detected ? detected : level.radius, // a lens has no other limit
  };
}

const tiltName = radians =>
  signedDegrees(Math.abs(radians)).replace('+', '') + (radians < 0 ? ' up' : ' down');

/** The i-th direction of a camera in words; empty if it can neither pan nor tilt. */
export const directionName = ({pans, tilts}, i) =>
  [pans && signedDegrees(pans[i]), tilts && tiltName(tilts[i])].filter(Boolean).join(', ');

/** A view in words. */
export const viewName = (pose, view) =>
  [`level ${view % pose.levels.length}`, directionName(pose, Math.floor(view / pose.levels.length))]
    .filter(Boolean)
    .join(', ');

/** The pose of a camera of a run in a frame. */
export function poseAt({poses, step}, camera, frame) {
  let last = poses[camera].length - 1;
  while (last > 0 && poses[camera][last].step > step[frame]) last--;
  return poses[camera][last].pose;
}

/** The view that a camera of a run has in a frame; -1 while it turns and sees nothing. */
export const seenAt = ({seeing, level}, camera, frame) => (seeing[camera] ?? level[camera])[frame];

/** The view of a camera of a run in a frame: the one it has, or else the one it is turning to. */
export function viewAt(run, camera, frame) {
  const seen = seenAt(run, camera, frame);
  return viewOf(poseAt(run, camera, frame), seen < 0 ? run.level[camera][frame] : seen);
}

/** Adds a sector or a full circle about a camera to the path. Headings are clockwise from +y. */
function sector(path, map, {x, y, heading, viewingAngle}, radius) {
  const [cx, cy, r] = [map.x(x), map.y(y), map.scale * radius];
  if (viewingAngle >= 2 * Math.PI) {
    path.moveTo(cx + r, cy);
    path.arc(cx, cy, r, 0, 2 * Math.PI);
  } else {
    const along = heading - Math.PI / 2;
    path.moveTo(cx, cy);
    path.arc(cx, cy, r, along - viewingAngle / 2, along + viewingAngle / 2);
    path.closePath();
  }
}

/** Adds the part of a view between two distances to the path; fill it by the rule `evenodd`. */
export function band(path, map, view, from, to) {
  sector(path, map, view, to);
  if (from > 0) sector(path, map, view, from);
}

/** Adds a ring to the path; `corners` are x and y in turn, in metres. */
export function ring(path, map, corners) {
  for (let i = 0; i < corners.length; i += 2)
    path[i ? 'lineTo' : 'moveTo'](map.x(corners[i]), map.y(corners[i + 1]));
  path.closePath();
}

/** The corners of the ground that is in the picture, x and y in turn, in metres. */
function trapezoid({x, y, heading, ground}) {
  const [sine, cosine] = [Math.sin(heading), Math.cos(heading)];
  return ground.map((metres, i) =>
    i % 2 ? y + metres * cosine - ground[i - 1] * sine : x + metres * cosine + ground[i + 1] * sine,
  );
}

/** Calls `draw` with the path clipped to the ground in the picture that no wall hides. */
export function inSight(context, map, view, draw) {
  if (view.ground && !view.ground.length) return; // all of the picture is above the ground
  const rings = [view.visible, view.ground && trapezoid(view)].filter(corners => corners);
  if (!rings.length) return draw();
  context.save();
  rings.forEach(corners => {
    context.beginPath();
    ring(context, map, corners);
    context.clip();
  });
  draw();
  context.restore();
}

/** Adds the border of the field to the path. */
export const fieldBorder = (path, map, {minX, maxX, minY, maxY}) =>
  path.rect(map.x(minX), map.y(maxY), map.x(maxX) - map.x(minX), map.y(minY) - map.y(maxY));

/** Adds the border of a view to the path: its sector, and the ground that is in the picture. */
export function border(path, map, view) {
  if (view.ground) ring(path, map, trapezoid(view));
  sector(path, map, view, view.reach);
}

/** Fills the ranges of a view in which a target of the usual size is detected. */
export function fillDetected(context, map, view) {
  view.level.detected.forEach(({from, to}) => {
    context.beginPath();
    band(context, map, view, from, to);
    context.fill('evenodd');
  });
}

/** The pixels per metre at a point; NaN outside the picture, or if the density is not known. */
export function densityAt(view, x, y) {
  const [right, up] = [x - view.x, y - view.y];
  const turn = Math.atan2(right, up) - view.heading;
  const offAxis = Math.abs(turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI)));
  return view.density && offAxis <= view.viewingAngle / 2
    ? view.density / Math.hypot(right, up)
    : NaN;
}

/** The name of the density zone that a density, in pixels per metre, is in. */
export const densityZoneAt = density =>
  DENSITY_ZONES.find(({least}) => density >= least)?.name ?? 'less than overview';
