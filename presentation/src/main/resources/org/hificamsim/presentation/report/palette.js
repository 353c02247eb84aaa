// Shapes, widths and scales that mean something, once for pages and pictures. MEANING has the colours: Java's Palette, put before all scripts.

/** How many cameras cover a target, as colour, shape and width of its trail. */
export const COVER = [
  {label: 'no camera', colour: MEANING.unseen, width: 1.2},
  {label: '1 camera', colour: MEANING.once, width: 2},
  {label: '2 cameras', colour: MEANING.twice, width: 3},
  {label: '3 or more', colour: MEANING.often, width: 4.5},
];

/** The class of a target that k cameras cover. */
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

/** Adds the outline of a class's shape to the path: a cross, a triangle, a square or a circle. */
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

/** Zones of pixel density, IEC 62676-4:2025 as vendors report them, nearest first; `least` in pixels per metre. Pale is far: one shade differs from the next for every eye. */
export const ZONES = [
  {name: 'validate', least: 500, colour: '#2e0f28'},
  {name: 'characterise', least: 250, colour: '#56204a'},
  {name: 'perceive', least: 125, colour: '#96487a'},
  {name: 'discern', least: 80, colour: '#cc79a7'},
  {name: 'outline', least: 40, colour: '#e7b7d3'},
  {name: 'overview', least: 20, colour: '#f5e1ee'},
];

// Dark to light: viridis, which people with colour blindness read alike.
const SCALE = [
  [68, 1, 84],
  [59, 82, 139],
  [33, 145, 140],
  [94, 201, 98],
  [253, 231, 37],
];

/** The colour of a scale as [red, green, blue]; `share` is 0 for the least (the narrowest zoom level) and 1 for the most. */
export function scaleColour(share) {
  const at = Math.min(Math.max(share, 0), 1) * (SCALE.length - 1);
  const low = Math.min(Math.floor(at), SCALE.length - 2);
  return SCALE[low].map((from, i) => Math.round(from + (at - low) * (SCALE[low + 1][i] - from)));
}

/** Where a level lies between the narrowest and the widest, 0 to 1. */
export const levelShare = (level, levels) => (levels > 1 ? level / (levels - 1) : 1);
