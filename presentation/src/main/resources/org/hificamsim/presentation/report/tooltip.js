// The tooltip of a field, which describes the camera, the target or else the point under the
// pointer.
import {el} from './dom.js';
import {decimals, metres} from './numbers.js';
import {describeObstacle, obstacleAt} from './site.js';
import {densityAt, densityZoneAt, viewName, viewOf} from './views.js';

const GAP = 16; // pixels between the pointer and the tooltip

export class Tooltip {
  constructor(surface) {
    this.surface = surface;
    this.element = el('div', {class: 'tip', hidden: true});
  }

  hide() {
    this.element.hidden = true;
  }

  /** Shows lines of text at a point, in pixels; without lines, hides the tooltip. */
  show(lines, [x, y]) {
    const {element, surface} = this;
    element.hidden = !lines.length;
    if (!lines.length) return;
    element.textContent = lines.join('\n');
    const left = start(x, element.offsetWidth, surface.width);
    const top = start(y, element.offsetHeight, surface.height);
    element.style.transform = `translate(${left}px, ${top}px)`;
  }
}

/** The start of a tooltip along one axis: after the pointer, or before it if it would not fit. */
function start(pointer, size, available) {
  const after = pointer + GAP;
  return Math.max(0, after + size <= available ? after : pointer - GAP - size);
}

/** Describes a target of a run in a frame. */
export function describeTarget(run, frame, target) {
  const {targets, widths} = run.setup;
  const k = run.coverage[target][frame];
  const width = widths ? `, ${decimals(widths[target], 3)} m wide` : '';
  return [
    `target ${targets[target].name}`,
    `x ${metres(run.x[target][frame])}, y ${metres(run.y[target][frame])}`,
    `covered by ${k} camera${k === 1 ? '' : 's'}`,
    `size ${decimals(targets[target].size, 3)} m${width}`,
  ];
}

/** Describes a camera of a run in a frame. */
export function describeCamera(run, frame, camera) {
  const pose = run.pose(camera, frame);
  const turning = run.seen(camera, frame) < 0 ? ', turning to it: sees nothing' : '';
  return [
    `camera ${run.setup.cameras[camera].name}`,
    `x ${metres(pose.x)}, y ${metres(pose.y)}`,
    run.online[camera][frame]
      ? describeView(pose, run.level[camera][frame]) + turning
      : 'not online',
    detections(run, frame, camera),
  ].filter(Boolean);
}

/** The number of targets that a camera detects in a frame; empty where there are none. */
export const detections = (run, frame, camera) =>
  run.targets[frame]
    ? `detects ${run.detected[camera][frame]} of ${run.targets[frame]} targets`
    : '';

function describeView(pose, view) {
  const {level, viewingAngle} = viewOf(pose, view);
  const degrees = (viewingAngle * 180) / Math.PI;
  const extent = pose.lenses
    ? `${decimals(degrees, 1)}° wide`
    : `radius ${decimals(level.radius, 3)} m`;
  return `${viewName(pose, view)}, ${extent}`;
}

/**
 * Describes a point, in pixels: the obstacle there, its pixel density and its cell of the heat map,
 * as far as they are shown.
 */
export function describePlace(field, [px, py]) {
  const {surface, run, map, frame, heat, selected} = field;
  const context = surface.canvas.getContext('2d');
  const obstacle = obstacleAt(context, run.setup.obstacles ?? [], map, surface.unit, [px, py]);
  const lines = obstacle ? [describeObstacle(obstacle)] : [];
  const [x, y] = map.place(px, py);
  if (field.densityZones && run.online[selected]?.[frame]) {
    const density = densityAt(field.view(selected), x, y);
    if (Number.isFinite(density))
      lines.push(`${decimals(density, 1)} px/m: ${densityZoneAt(density)}`);
  }
  return heat ? lines.concat(heat.describe(x, y)) : lines;
}
