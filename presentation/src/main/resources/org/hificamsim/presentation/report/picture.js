// Scenes as Java's FieldScript asks for them: the numbers of a run come as Java's arrays, all else as JSON. Rhino runs this file: see scene.js.
import {
  fit,
  hatch,
  HEAT,
  heightFor,
  LAYERS,
  legend,
  MAP_LAYERS,
  NEVER,
  paintScene,
  PLAN_LAYERS,
  paintTracks,
} from './scene.js';
import {scaleColour} from './palette.js';

const TRACK_POINTS = 200000;

/** How high a field is in a picture of this width. */
export const height = (setup, width) => heightFor(setup.field, width);

/** What the signs in a picture mean: see legend. */
export const signs = (setup, colours, zoned, host) =>
  legend({run: {setup}, colours, zoned, host, unit: 1});

/** Some colours of a heat map's scale, from the least to the most, as they are seen on white. */
export const scale = count =>
  Array.from({length: count}, (none, i) =>
    scaleColour((i + 0.5) / count).map(part => Math.round(255 - HEAT * (255 - part))),
  );

/** How a heat map fills what no camera ever covers. */
export const never = host => hatch(host, NEVER, 1);

/**
 * Paints a frame, or a heat map or the cells of a plan where there are such.
 * @param columns of the run: `frame`, the one that is shown, `most`, and the lists `step`, `online`, ...
 * @param zoned the camera whose pixel densities are shown, -1 for none
 */
export function paint(
  host,
  setup,
  colours,
  width,
  height,
  columns,
  poses,
  images,
  opacity,
  zoned,
  tracked,
  heat,
  values,
) {
  const count = columns.step.length;
  const scene = {
    run: {...columns, setup, count, poses: JSON.parse(poses).map(pose => [{step: -1, pose}])},
    frame: columns.frame,
    map: fit(setup.field, width, height, 1),
    unit: 1,
    colours,
    selected: -1,
    zoned,
    heat: heat && {...JSON.parse(heat), values},
    floor: (setup.floor ?? []).map(({area}, i) => ({area, image: images[i]})),
    opacity,
    host,
    trails: true,
  };
  const every = 1 + Math.floor((count * setup.targets.length) / TRACK_POINTS);
  if (tracked) scene.tracks = () => paintTracks(host, scene, 0, every);
  paintScene(host, scene, scene.heat?.classes ? PLAN_LAYERS : heat ? MAP_LAYERS : LAYERS);
}
