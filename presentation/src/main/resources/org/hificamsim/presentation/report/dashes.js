// Dash patterns. Rhino runs this file too: see scene.js.

/** Returns a dash pattern in pixels, from one in units of a picture. */
export const scaledDashes = (pattern, unit) => pattern.map(length => length * unit);
