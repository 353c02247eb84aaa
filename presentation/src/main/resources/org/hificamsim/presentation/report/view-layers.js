// The layers of views, density zones, and areas that walls hide. Rhino runs this file too: see
// scene.js.
import {scaledDashes} from './dashes.js';
import {hatch} from './hatch.js';
import {DENSITY_ZONES} from './palette.js';
import {band, border, fieldBorder, fillDetected, inSight, seenAt, viewAt} from './views.js';

/** The dash patterns of a field of view, and of one that its camera is still turning to. */
export const VIEW_DASHES = [5, 4];
export const BLIND_DASHES = [2, 5];

/** Paints the density zones of a camera, each with its name at its far end. */
export function densityZones(context, {densityCamera, run, frame, map, colours, unit}) {
  if (
    densityCamera < 0 ||
    !run.online[densityCamera][frame] ||
    seenAt(run, densityCamera, frame) < 0
  )
    return;
  const view = viewAt(run, densityCamera, frame);
  const reaches = DENSITY_ZONES.map(({least}) => view.density / least);
  inSight(context, map, view, () => {
    context.globalAlpha = 0.6;
    DENSITY_ZONES.forEach(({colour}, i) => {
      context.beginPath();
      band(context, map, view, i ? reaches[i - 1] : 0, reaches[i]);
      context.fillStyle = colour;
      context.fill('evenodd');
    });
    context.globalAlpha = 1;
  });
  context.fillStyle = colours.ink;
  context.strokeStyle = colours.paper;
  context.lineWidth = 3 * unit;
  context.lineJoin = 'round';
  context.font = `${11 * unit}px sans-serif`;
  context.textAlign = 'center';
  DENSITY_ZONES.forEach(({name, least}, i) => {
    const [x, y] = [
      map.x(view.x + reaches[i] * Math.sin(view.heading)),
      map.y(view.y + reaches[i] * Math.cos(view.heading)),
    ];
    context.strokeText(`${name} ${least}`, x, y);
    context.fillText(`${name} ${least}`, x, y);
  });
}

/**
 * Draws the borders of all fields of view, and fills the ranges in which a target of the usual size
 * is detected.
 */
export function views(context, scene) {
  const {run, frame, map, colours, unit, selected, densityCamera} = scene;
  context.fillStyle = context.strokeStyle = colours.range;
  onlineCameras(scene).forEach(camera => {
    const blind = seenAt(run, camera, frame) < 0;
    const chosen = camera === selected;
    const view = viewAt(run, camera, frame);
    inSight(context, map, view, () => {
      context.globalAlpha = chosen ? 0.4 : 0.13;
      if (!blind && camera !== densityCamera && !scene.heat) fillDetected(context, map, view);
      context.globalAlpha = chosen || scene.heat ? 1 : 0.55;
      context.lineWidth = (chosen ? 2.5 : 1) * unit;
      context.setLineDash(
        scaledDashes(blind ? BLIND_DASHES : chosen || scene.heat ? [] : VIEW_DASHES, unit),
      );
      context.beginPath();
      border(context, map, view);
      context.stroke();
    });
  });
}

const onlineCameras = ({run, frame}) =>
  run.setup.cameras.map((spec, camera) => camera).filter(camera => run.online[camera][frame]);

/** Hatches what some camera would detect in the field if no wall hid it from all cameras. */
export function shadows(context, scene) {
  const {run, frame, map, colours, unit, host} = scene;
  const seeingViews = onlineCameras(scene)
    .filter(camera => seenAt(run, camera, frame) >= 0)
    .map(camera => viewAt(run, camera, frame));
  const wallViews = seeingViews.filter(({visible}) => visible);
  if (scene.heat || !wallViews.length) return;
  context.save();
  context.beginPath();
  fieldBorder(context, map, run.setup.field);
  context.clip();
  host.through(
    context,
    mask => {
      wallViews.forEach(view =>
        inSight(mask, map, {...view, visible: undefined}, () => fillDetected(mask, map, view)),
      );
      mask.globalCompositeOperation = 'destination-out';
      seeingViews.forEach(view => inSight(mask, map, view, () => fillDetected(mask, map, view)));
    },
    hatch(host, colours.shadow, unit),
  );
  context.restore();
}
