// Maps from metres in the field, where y points up, to pixels. Rhino runs this file too: see
// scene.js.

const [SIDE_MARGIN, END_MARGIN] = [46, 36]; // pixels, for the numbers along the field's borders

/**
 * Returns the map that shows the whole field as large as possible in the middle of a box of this
 * size, in pixels. `x`, `y` and `scale` turn metres into pixels; `place` turns pixels into metres.
 */
export function fit({minX, maxX, minY, maxY}, width, height, unit) {
  const scale = Math.max(
    1e-9,
    Math.min(
      (width - 2 * SIDE_MARGIN * unit) / (maxX - minX),
      (height - 2 * END_MARGIN * unit) / (maxY - minY),
    ),
  );
  const left = width / 2 - (scale * (minX + maxX)) / 2;
  const top = height / 2 + (scale * (minY + maxY)) / 2;
  return {
    scale,
    width,
    height,
    x: x => left + scale * x,
    y: y => top - scale * y,
    place: (px, py) => [(px - left) / scale, (top - py) / scale],
  };
}

/** Returns a map magnified by a factor and moved by `left` and `top`, in pixels. */
export const magnified = ({x, y, scale, width, height, place}, times, left, top) => ({
  scale: scale * times,
  width,
  height,
  times,
  x: metres => left + times * x(metres),
  y: metres => top + times * y(metres),
  place: (px, py) => place((px - left) / times, (py - top) / times),
});

/** The height of a picture whose width the field fills; both in pixels. */
export const heightFor = ({minX, maxX, minY, maxY}, width) =>
  2 * END_MARGIN + (width - 2 * SIDE_MARGIN) * ((maxY - minY) / (maxX - minX));
