// The layers of cameras and targets. Rhino runs this file too: see scene.js.
import {figureSize} from './figure-size.js';
import {COVER, coverClass, shape} from './palette.js';
import {poseAt, viewAt} from './views.js';

const LABELLED_RADIUS = 6; // pixels; smaller figures have no number

/**
 * Draws a square for each camera, with a short line along its view; hollow and crossed out if
 * offline.
 */
export function cameras(context, scene) {
  const {run, frame, map, colours, selected} = scene;
  const size = figureSize(scene);
  run.setup.cameras.forEach((camera, i) => {
    const {heading, viewingAngle} = viewAt(run, i, frame);
    const pose = poseAt(run, i, frame);
    const [x, y] = [map.x(pose.x), map.y(pose.y)];
    const r = (i === selected ? 7 : 5) * size;
    const online = run.online[i][frame];
    context.lineWidth = 1.5 * size;
    context.fillStyle = online ? colours.camera : colours.paper;
    context.strokeStyle = online ? colours.paper : colours.camera;
    context.beginPath();
    context.rect(x - r, y - r, 2 * r, 2 * r);
    context.fill();
    context.stroke();
    context.strokeStyle = colours.camera;
    context.beginPath();
    if (viewingAngle < 2 * Math.PI) {
      context.moveTo(x, y);
      context.lineTo(x + 2.4 * r * Math.sin(heading), y - 2.4 * r * Math.cos(heading));
    }
    if (!online) {
      context.moveTo(x - r, y - r);
      context.lineTo(x + r, y + r);
    }
    context.stroke();
  });
}

/**
 * Draws each target as the shape of its cover class, with the number of cameras that cover it. The
 * shape has the target's width, but is never too small to be seen.
 */
export function targets(context, scene) {
  const {run, frame, map, colours} = scene;
  const size = figureSize(scene);
  const {targets, widths = targets.map(target => target.size), targetSize} = run.setup;
  const sameWidth = new Set(widths).size < 2;
  targets.forEach((target, i) => {
    if (!run.present[i][frame]) return;
    const k = run.coverage[i][frame];
    const kind = coverClass(k);
    const [x, y] = [map.x(run.x[i][frame]), map.y(run.y[i][frame])];
    const prominence = sameWidth ? 1 : Math.max(0.6, Math.min(2, widths[i] / targetSize));
    const r = Math.max(9 * size * prominence, (map.scale * widths[i]) / 2);
    context.fillStyle = COVER[kind].colour;
    context.strokeStyle = colours.ink;
    context.lineWidth = 1.5 * size;
    context.beginPath();
    shape(context, kind, x, y, r);
    context.fill();
    context.stroke();
    if (kind > 0 && r >= LABELLED_RADIUS) {
      context.fillStyle = '#000';
      context.font = `bold ${Math.round(r * 1.15)}px sans-serif`;
      context.textAlign = 'center';
      context.fillText(k, x, y + r * (kind === 1 ? 0.55 : 0.42));
    }
  });
}
