// The size of the figures that stand for cameras and targets. Rhino runs this file too: see
// scene.js.

const FULL_SIZE_SPACE = 56; // pixels around a figure; with less, figures shrink

/**
 * Returns the factor by which figures are drawn: smaller where there are many of them, larger
 * where the map is magnified.
 */
export function figureSize({run, map, unit}) {
  const space =
    (map.times ?? 1) *
    Math.sqrt((map.width * map.height) / (run.setup.cameras.length + run.mostTargets + 1));
  return unit * Math.max(0.25, Math.min(1, space / (FULL_SIZE_SPACE * unit)));
}
