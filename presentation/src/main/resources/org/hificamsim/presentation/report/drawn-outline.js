// Paints the outline that is being drawn between two points of a field.

const PATHS = {
  line: (context, [x1, y1, x2, y2]) => {
    context.moveTo(x1, y1);
    context.lineTo(x2, y2);
  },
  rectangle: (context, [x1, y1, x2, y2]) => context.rect(x1, y1, x2 - x1, y2 - y1),
  circle: (context, [x1, y1, x2, y2]) =>
    context.arc(x1, y1, Math.hypot(x2 - x1, y2 - y1), 0, 2 * Math.PI),
};

/**
 * Paints an outline and marks its first end.
 * @param outline the name of one of the paths above
 * @param ends x1, y1, x2 and y2, in metres
 */
export function paintOutline(context, {map, unit, colours}, outline, [x1, y1, x2, y2]) {
  context.strokeStyle = context.fillStyle = colours.accent;
  context.lineWidth = 3 * unit;
  const pixels = [map.x(x1), map.y(y1), map.x(x2), map.y(y2)];
  context.beginPath();
  PATHS[outline](context, pixels);
  context.stroke();
  context.beginPath();
  context.arc(pixels[0], pixels[1], 4 * unit, 0, 2 * Math.PI);
  context.fill();
}
