// The functions that the Java class FieldScript calls to paint scenes. The numbers of a run are
// Java arrays, everything else is JSON. Rhino runs this file: see scene.js.
import {hatch} from './hatch.js';
import {HEAT_OPACITY, NEVER_COVERED} from './heat-layer.js';
import {legend} from './legend.js';
import {fit, heightFor} from './map.js';
import {scaleColour} from './palette.js';
import {paintTracks} from './path-layers.js';
import {LAYERS, MAP_LAYERS, paintScene} from './scene.js';

const MOST_TRACK_POINTS = 200000;

/** The height of a picture of this width, in pixels. */
export const height = (setup, width) => heightFor(setup.field, width);

/** The legend of a picture: see legend.js. */
export const signs = (setup, colours, densityCamera, host) =>
  legend({run: {setup}, colours, densityCamera, host, unit: 1});

/** `count` colours of a heat map's scale, from the least value on, as they look on white. */
export const scale = count =>
  Array.from({length: count}, (none, i) =>
    scaleColour((i + 0.5) / count).map(part => Math.round(255 - HEAT_OPACITY * (255 - part))),
  );

/** The fill style of cells that no camera ever covers. */
export const never = host => hatch(host, NEVER_COVERED, 1);

/**
 * Paints a frame of a run, a heat map or the cells of a plan.
 * @param picture `colours`; `width` and `height` in pixels; `columns` of the run: the `frame` that
 *   is shown, `mostTargets`, and the lists `step`, `online`, ...; `poses` of the cameras as JSON;
 *   `images` of the floor and their `opacity`; `densityCamera`, the camera whose density zones
 *   are shown, -1 for none; `tracked`, whether tracks are shown
 * @param heat the figure of the heat map that is shown, as JSON; null for none
 * @param values the values of the figure's cells
 */
export function paint(host, setup, picture, heat, values) {
  const {colours, width, height, columns, poses, images, opacity, densityCamera, tracked} = picture;
  const count = columns.step.length;
  const scene = {
    run: {...columns, setup, count, poses: JSON.parse(poses).map(pose => [{step: -1, pose}])},
    frame: columns.frame,
    map: fit(setup.field, width, height, 1),
    unit: 1,
    colours,
    selected: -1,
    densityCamera,
    heat: heat && {...JSON.parse(heat), values},
    floor: (setup.floor ?? []).map(({area}, i) => ({area, image: images[i]})),
    opacity,
    host,
    trails: true,
  };
  const every = 1 + Math.floor((count * setup.targets.length) / MOST_TRACK_POINTS);
  if (tracked) scene.tracks = () => paintTracks(host, scene, 0, every);
  paintScene(host, scene, heat ? MAP_LAYERS : LAYERS);
}
