// What a camera sees in one of its views: a zoom level at a pan angle, cut off by walls.

/** How many views a camera in this pose can choose. */
export const viewCount = ({levels, pans}) => levels.length * (pans?.length || 1);

/** One of a camera's views: its zoom level, and direction and opening angle in radians. */
export function viewOf(pose, view) {
  const zoom = view % pose.levels.length;
  const pan = pose.pans?.[Math.floor(view / pose.levels.length)] ?? 0;
  const lens = pose.lenses?.[zoom];
  const level = pose.levels[zoom];
  const detected = Math.max(0, ...level.detected.map(({to}) => to));
  return {
    zoom, pan, level, x: pose.x, y: pose.y, visible: pose.visible, heading: pose.heading + pan,
    viewingAngle: lens?.viewingAngle ?? pose.viewingAngle, density: lens?.density ?? 0,
    reach: lens && detected ? detected : level.radius, // a lens reaches as far as it detects
  };
}

/** Adds a sector or a full circle about a camera to the path; headings run clockwise from +y, which is upwards. */
export function sector(path, map, {x, y, heading, viewingAngle}, radius) {
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

/** Adds corners, x and y in turn in metres, to the path as a ring. */
export function ring(path, map, corners) {
  for (let i = 0; i < corners.length; i += 2) path[i ? 'lineTo' : 'moveTo'](map.x(corners[i]), map.y(corners[i + 1]));
  path.closePath();
}

/** Draws where nothing solid is between the camera and what is drawn. */
export function inSight(context, map, {visible}, draw) {
  if (!visible) return draw();
  context.save();
  context.beginPath();
  ring(context, map, visible);
  context.clip();
  draw();
  context.restore();
}

/** Fills the ranges of a view in which a target of the usual size is detected. */
export function fillDetected(context, map, view) {
  for (const {from, to} of view.level.detected) {
    context.beginPath();
    sector(context, map, view, to);
    if (from > 0) sector(context, map, view, from);
    context.fill('evenodd');
  }
}

/** Radians as whole degrees, with a sign. */
export const signed = radians => {
  const degrees = Math.round((radians * 180) / Math.PI);
  return `${degrees > 0 ? '+' : degrees < 0 ? '−' : ''}${Math.abs(degrees)}°`;
};
