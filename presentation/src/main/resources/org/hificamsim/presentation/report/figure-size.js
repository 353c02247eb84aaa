// The size of the symbols of cameras and targets. Rhino runs this file too: see scene.js.

const FULL_SIZE_SPACE = 56; // pixels between symbols; with less, symbols shrink

/**
 * Returns the factor by which symbols are scaled: smaller if there are many of them, larger if the
 * map is magnified.
 */
export function figureSize({run, map, unit}) {
  const space =
    (map.times ?? 1) *
    Math.sqrt((map.width * map.height) / (run.setup.cameras.length + run.mostTargets + 1));
  return unit * Math.max(0.25, Math.min(1, space / (FULL_SIZE_SPACE * unit)));
}
