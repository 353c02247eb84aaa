// How many cameras cover a target, as colour (Okabe and Ito), shape and width of its trail.

export const COVER = [
  {label: 'no camera', colour: '#d55e00', width: 1.2},
  {label: '1 camera', colour: '#e69f00', width: 2},
  {label: '2 cameras', colour: '#56b4e9', width: 3},
  {label: '3 or more', colour: '#009e73', width: 4.5},
];

/** The class of a target that k cameras cover. */
export const coverClass = k => Math.min(k, COVER.length - 1);

/** Adds the outline of a class's shape to the path: a cross, a triangle, a square or a circle. */
export function shape(path, kind, x, y, r) {
  if (kind === 0) {
    const a = r * 0.45;
    const corners = [[-r, -r + a], [-r + a, -r], [0, -a], [r - a, -r], [r, -r + a], [a, 0], [r, r - a], [r - a, r],
      [0, a], [-r + a, r], [-r, r - a], [-a, 0]];
    corners.forEach(([dx, dy], i) => (i ? path.lineTo(x + dx, y + dy) : path.moveTo(x + dx, y + dy)));
    path.closePath();
  } else if (kind === 1) {
    path.moveTo(x, y - 1.15 * r);
    path.lineTo(x + 1.1 * r, y + 0.8 * r);
    path.lineTo(x - 1.1 * r, y + 0.8 * r);
    path.closePath();
  } else if (kind === 2) {
    path.rect(x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r);
  } else {
    path.moveTo(x + r, y);
    path.arc(x, y, r, 0, 2 * Math.PI);
  }
}

// From the narrowest zoom level to the widest: dark to light, as viridis runs.
const LEVELS = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];

/** The colour of a level as [red, green, blue]; `share` is 0 for the narrowest and 1 for the widest. */
export function levelColour(share) {
  const at = Math.min(Math.max(share, 0), 1) * (LEVELS.length - 1);
  const low = Math.min(Math.floor(at), LEVELS.length - 2);
  return LEVELS[low].map((from, i) => Math.round(from + (at - low) * (LEVELS[low + 1][i] - from)));
}

/** Where a level lies between the narrowest and the widest, 0 to 1. */
export const levelShare = (level, levels) => (levels > 1 ? level / (levels - 1) : 1);
