// The layers of the ground: floor plans, the grid, and the scale bar. Rhino runs this file too: see
// scene.js.
import {decimals} from './numbers.js';
import {fieldBorder} from './views.js';

/** Paints the pictures of the floor. */
export function floor(context, {map, floor, opacity}) {
  context.globalAlpha = opacity;
  floor.forEach(({area: {minX, maxX, minY, maxY}, image}) =>
    context.drawImage(
      image,
      map.x(minX),
      map.y(maxY),
      map.scale * (maxX - minX),
      map.scale * (maxY - minY),
    ),
  );
}

/** Draws grid lines with their coordinates in metres, and the border of the field. */
export function grid(context, {map, colours, unit, run}) {
  const {minX, maxX, minY, maxY} = run.setup.field;
  const gap = niceGap((90 * unit) / map.scale);
  context.lineWidth = 1;
  context.strokeStyle = colours.grid;
  context.fillStyle = colours.faint;
  context.font = `${11 * unit}px sans-serif`;
  context.beginPath();
  context.textAlign = 'center';
  for (let x = Math.ceil(minX / gap) * gap; x <= maxX + 1e-9; x += gap) {
    context.moveTo(map.x(x), map.y(minY));
    context.lineTo(map.x(x), map.y(maxY));
    context.fillText(decimals(x, 3), map.x(x), map.y(minY) + 14 * unit);
  }
  context.textAlign = 'right';
  for (let y = Math.ceil(minY / gap) * gap; y <= maxY + 1e-9; y += gap) {
    context.moveTo(map.x(minX), map.y(y));
    context.lineTo(map.x(maxX), map.y(y));
    context.fillText(decimals(y, 3), map.x(minX) - 5 * unit, map.y(y) + 4 * unit);
  }
  context.stroke();
  context.beginPath();
  context.strokeStyle = colours.faint;
  fieldBorder(context, map, run.setup.field);
  context.stroke();
}

/** Draws a bar with its length in metres in the lower right corner of the picture. */
export function scaleBar(context, {map, colours, unit}) {
  const metres = niceGap((60 * unit) / map.scale);
  const [right, bottom, length] = [
    map.width - 12 * unit,
    map.height - 6 * unit,
    map.scale * metres,
  ];
  context.fillStyle = colours.paper;
  context.globalAlpha = 0.75;
  context.fillRect(right - length - 70 * unit, bottom - 11 * unit, length + 76 * unit, 16 * unit);
  context.globalAlpha = 1;
  context.strokeStyle = context.fillStyle = colours.ink;
  context.lineWidth = 1.5 * unit;
  context.beginPath();
  [
    [0, -5],
    [0, 0],
    [-length, 0],
    [-length, -5],
  ].forEach(([dx, dy], i) => context[i ? 'lineTo' : 'moveTo'](right + dx, bottom + dy * unit));
  context.stroke();
  context.font = `${11 * unit}px sans-serif`;
  context.textAlign = 'right';
  context.fillText(`${decimals(metres, 3)} m`, right - length - 5 * unit, bottom);
}

/**
 * Returns the least number of the form 1, 2 or 5 times a power of ten that is not below `least`.
 */
function niceGap(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * [1, 2, 5, 10].find(factor => factor * power >= least);
}
