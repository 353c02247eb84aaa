// Hatching: a pale ground with diagonal lines, which show on light and on dark floors. Rhino runs
// this file too: see scene.js.

const hatches = new Map();

/**
 * Returns a hatching as a fill style.
 * @param unit the scale of the lines: 1 for lines 7 pixels apart
 */
export function hatch(host, colour, unit) {
  const key = `${colour} ${unit}`;
  const side = Math.round(7 * unit);
  if (!hatches.has(key)) {
    hatches.set(
      key,
      host.pattern(side, tile => {
        tile.fillStyle = tile.strokeStyle = colour;
        tile.globalAlpha = 0.22;
        tile.fillRect(0, 0, side, side);
        tile.globalAlpha = 0.7;
        tile.beginPath();
        [-side, 0, side].forEach(from => {
          tile.moveTo(from, side);
          tile.lineTo(from + side, 0);
        });
        tile.stroke();
      }),
    );
  }
  return hatches.get(key);
}
