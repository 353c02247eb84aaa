// Dash patterns. Rhino runs this file too: see scene.js.

/** A dash pattern in units of a picture. */
export const scaledDashes = (pattern, unit) => pattern.map(length => length * unit);
