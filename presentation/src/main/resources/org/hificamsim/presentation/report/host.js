// What scenes need that a browser's canvas does in its own way: see paintScene.

const layer = document.createElement('canvas');
const tiles = new Map();

/** A tile of pale ground and a diagonal line, which shows on light and on dark floors. */
function tile(colour, side) {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = side;
  const context = canvas.getContext('2d');
  context.fillStyle = context.strokeStyle = colour;
  context.globalAlpha = 0.22;
  context.fillRect(0, 0, side, side);
  context.globalAlpha = 0.7;
  context.beginPath();
  for (const from of [-side, 0, side]) {
    context.moveTo(from, side);
    context.lineTo(from + side, 0);
  }
  context.stroke();
  return context.createPattern(canvas, 'repeat');
}

export const host = {
  hatch(colour, unit) {
    const key = `${colour} ${Math.round(7 * unit)}`;
    if (!tiles.has(key)) tiles.set(key, tile(colour, Math.round(7 * unit)));
    return tiles.get(key);
  },

  cells(columns, rows, colourOf) {
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [columns, rows];
    const context = canvas.getContext('2d');
    const image = context.createImageData(columns, rows);
    for (let cell = 0; cell < columns * rows; cell++) {
      const colour = colourOf(cell);
      if (colour) image.data.set([...colour, 255], 4 * ((rows - 1 - Math.floor(cell / columns)) * columns + (cell % columns)));
    }
    context.putImageData(image, 0, 0);
    return canvas;
  },

  through(context, mask, style) {
    const {width, height} = context.canvas;
    [layer.width, layer.height] = [width, height];
    const masked = layer.getContext('2d');
    masked.setTransform(context.getTransform());
    mask(masked);
    masked.globalCompositeOperation = 'source-in';
    masked.fillStyle = style;
    masked.fillRect(0, 0, width, height);
    context.save();
    context.resetTransform();
    context.drawImage(layer, 0, 0);
    context.restore();
  },
};
