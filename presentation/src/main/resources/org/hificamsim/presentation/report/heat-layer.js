// The layer of a heat map. Rhino runs this file too: see scene.js.
import {hatch} from './hatch.js';
import {COVER, scaleColour} from './palette.js';

/** The opacity of a heat map over the floor. */
export const HEAT_OPACITY = 0.8;

/** The colour of cells that no camera ever covers: that of targets that no camera covers. */
export const NEVER_COVERED = COVER[0].colour;

/**
 * Colours cells by their values and hatches those of value 0; cells without a value stay empty.
 */
export function heat(context, {heat, map, run, unit, host}) {
  if (!heat) return;
  const {columns, rows, values, end, logarithmic} = heat;
  const share = value =>
    logarithmic ? (end > 1 ? Math.log(value) / Math.log(end) : 1) : value / end;
  const {minX, maxX, minY, maxY} = run.setup.field;
  const [left, bottom, width, height] = [
    map.x(minX),
    map.y(minY),
    map.scale * (maxX - minX),
    map.scale * (maxY - minY),
  ];
  context.beginPath();
  for (let cell = 0; cell < values.length; cell++) {
    if (values[cell] !== 0) continue;
    let row = Math.floor(cell / columns);
    context.rect(
      left + ((cell - row * columns) * width) / columns,
      bottom - ((1 + row) * height) / rows,
      width / columns,
      height / rows,
    );
  }
  context.fillStyle = hatch(host, NEVER_COVERED, unit);
  context.fill();
  context.globalAlpha = HEAT_OPACITY;
  context.imageSmoothingEnabled = false;
  heat.image ??= host.cells(columns, rows, cell =>
    values[cell] > 0 ? scaleColour(share(values[cell])) : null,
  );
  context.drawImage(heat.image, left, bottom - height, width, height);
}
