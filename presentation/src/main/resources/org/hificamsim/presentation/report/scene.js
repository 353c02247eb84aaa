// Paints the field in one frame of a run, layer by layer: pages on their canvas, pictures on Java's
// ScriptCanvas. To add a layer, write a function in one of the modules imported here, add it to
// LAYERS, and add what it shows to the scene.
//
// Browsers run this file and those that it imports, and so does Rhino, which knows neither classes
// nor spread arguments, and in the head of a for loop neither const nor destructuring.
import {beliefs, messages} from './belief-layers.js';
import {cameras, targets} from './figure-layers.js';
import {floor, grid, scaleBar} from './ground-layers.js';
import {heat} from './heat-layer.js';
import {obstacles} from './obstacle-layer.js';
import {tracks, trails} from './path-layers.js';
import {densityZones, shadows, views} from './view-layers.js';
import {zoneNames, zones} from './zone-layer.js';

/** All layers, the lowest first. */
export const LAYERS = [
  floor,
  grid,
  heat,
  beliefs,
  zones,
  densityZones,
  views,
  shadows,
  obstacles,
  tracks,
  trails,
  zoneNames,
  messages,
  cameras,
  targets,
  scaleBar,
];

/** The layers of a heat map's picture, which leaves out what belongs to one step. */
export const MAP_LAYERS = [floor, grid, heat, obstacles, tracks, cameras, scaleBar];

/**
 * Paints layers of a scene, an object with
 * - `run`: the run, with `setup`, `mostTargets` (the most present at once), and lists by
 *   camera or target and by frame; `frame`: the index in these lists
 * - `map`: from `fit`; `unit`: the factor by which lengths in pixels grow with the text
 * - `colours`: by their names in the style sheet
 * - `selected`: the selected camera; `densityCamera`: the one whose density zones are shown; -1 for
 *   none
 * - `heat`: a record ShownFigure with `columns`, `rows` and `values`, or nothing
 * - `floor`: a list of {area, image}, painted with `opacity`
 * - `trails`: whether the targets' last steps are shown; `tracks(context)`: paints their tracks, or
 *   nothing
 * - `zones`: a list of records ShownZone, or nothing
 * - `belief`: a record BeliefFrame, or nothing
 * - `host`: functions that differ between canvases. `pattern(side, paint)` returns a fill style,
 *   `cells(columns, rows, colourOf)` returns an image, and `through(context, mask, style)` fills
 *   the area that `mask(canvas)` covers
 */
export function paintScene(context, scene, layers = LAYERS) {
  layers.forEach(layer => {
    context.save();
    layer(context, scene);
    context.restore();
  });
}
