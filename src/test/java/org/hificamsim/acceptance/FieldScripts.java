package org.hificamsim.acceptance;

/** Scripts that query the field on a page; their arguments are a place in metres. */
final class FieldScripts {
  /** The script that returns the colour of the field at a place. */
  static final String COLOUR =
      """
const {map, surface} = (hificamsim.player ?? hificamsim.players[0]).field;
const at = [map.x(arguments[0]), map.y(arguments[1])].map(pixel => Math.round(pixel * surface.ratio));
return [...surface.canvas.getContext('2d').getImageData(...at, 1, 1).data].join();
""";

  /** The script that returns the tooltip at a place. */
  static final String TOOLTIP =
      """
const {field} = hificamsim.player, {map, surface: {canvas}} = field, box = canvas.getBoundingClientRect();
canvas.dispatchEvent(new PointerEvent('pointermove', {clientX: box.left + map.x(arguments[0]), clientY: box.top + map.y(arguments[1])}));
return field.tooltip.element.hidden ? '' : field.tooltip.element.textContent;
""";

  private FieldScripts() {}
}
