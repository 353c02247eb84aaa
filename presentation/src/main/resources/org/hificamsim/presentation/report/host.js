// The functions of paintScene's `host` for the canvas of a browser.

const layer = document.createElement('canvas');

export const host = {
  pattern(side, paint) {
    const tile = document.createElement('canvas');
    tile.width = tile.height = side;
    const context = tile.getContext('2d');
    paint(context);
    return context.createPattern(tile, 'repeat');
  },

  cells(columns, rows, colourOf) {
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [columns, rows];
    const context = canvas.getContext('2d');
    const image = context.createImageData(columns, rows);
    for (let cell = 0; cell < columns * rows; cell++) {
      const colour = colourOf(cell);
      if (colour)
        image.data.set(
          [...colour, 255],
          4 * ((rows - 1 - Math.floor(cell / columns)) * columns + (cell % columns)),
        );
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
