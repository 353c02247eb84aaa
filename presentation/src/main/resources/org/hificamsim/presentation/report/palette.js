// The shapes, widths and colour scales of pages and pictures. Rhino runs this file too: see
// scene.js. MEANING has the colours of the Java class Palette, which writes it before all scripts.

/**
 * The classes of targets by the number of cameras that cover them, with the width of their trails.
 */
export const COVER = [
  {label: 'no camera', colour: MEANING.unseen, width: 1.2},
  {label: '1 camera', colour: MEANING.once, width: 2},
  {label: '2 cameras', colour: MEANING.twice, width: 3},
  {label: '3 or more', colour: MEANING.often, width: 4.5},
];

/** The class of a target that k cameras cover, an index of COVER. */
export const coverClass = k => Math.min(k, COVER.length - 1);

const CROSS = [
  [-1, -0.55],
  [-0.55, -1],
  [0, -0.45],
  [0.55, -1],
  [1, -0.55],
  [0.45, 0],
  [1, 0.55],
  [0.55, 1],
  [0, 0.45],
  [-0.55, 1],
  [-1, 0.55],
  [-0.45, 0],
];
const TRIANGLE = [
  [0, -1.15],
  [1.1, 0.8],
  [-1.1, 0.8],
];
const SQUARE = [
  [-0.9, -0.9],
  [0.9, -0.9],
  [0.9, 0.9],
  [-0.9, 0.9],
];

/** Adds the shape of a cover class to the path: a cross, a triangle, a square or a circle. */
export function shape(path, kind, x, y, r) {
  const corners = [CROSS, TRIANGLE, SQUARE][kind];
  if (corners) {
    corners.forEach(([dx, dy], i) =>
      i ? path.lineTo(x + r * dx, y + r * dy) : path.moveTo(x + r * dx, y + r * dy),
    );
    path.closePath();
  } else {
    path.moveTo(x + r, y);
    path.arc(x, y, r, 0, 2 * Math.PI);
  }
}

/**
 * The density zones of IEC 62676-4:2025, as vendors report them, the nearest first; `least` in
 * pixels per metre. Farther zones are paler, so that people with colour blindness can tell them
 * apart.
 */
export const DENSITY_ZONES = [
  {name: 'validate', least: 500, colour: '#2e0f28'},
  {name: 'characterise', least: 250, colour: '#56204a'},
  {name: 'perceive', least: 125, colour: '#96487a'},
  {name: 'discern', least: 80, colour: '#cc79a7'},
  {name: 'outline', least: 40, colour: '#e7b7d3'},
  {name: 'overview', least: 20, colour: '#f5e1ee'},
];

// Viridis, from dark to light; people with colour blindness can read it.
const SCALE = [
  [68, 1, 84],
  [59, 82, 139],
  [33, 145, 140],
  [94, 201, 98],
  [253, 231, 37],
];

/** The colour of a share of the scale, 0 to 1, as [red, green, blue]. */
export function scaleColour(share) {
  const position = Math.min(Math.max(share, 0), 1) * (SCALE.length - 1);
  const low = Math.min(Math.floor(position), SCALE.length - 2);
  return SCALE[low].map((from, i) =>
    Math.round(from + (position - low) * (SCALE[low + 1][i] - from)),
  );
}

/** The position of a zoom level on a scale from 0, the narrowest, to 1, the widest. */
export const levelShare = (level, levels) => (levels > 1 ? level / (levels - 1) : 1);
