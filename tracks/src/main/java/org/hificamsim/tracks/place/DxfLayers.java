package org.hificamsim.tracks.place;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/** The layers of a DXF. */
final class DxfLayers {
  /** The layer whose entities in a block take the layer of the insert that draws the block. */
  static final String LAYER_OF_INSERT = "0";

  private static final int FROZEN = 1;
  private static final int USUAL_COLOUR = 7;

  /**
   * A layer.
   *
   * @param colour number of the AutoCAD Color Index
   */
  private record Layer(boolean isOff, boolean isFrozen, int colour) {}

  private static final Layer USUAL = new Layer(false, false, USUAL_COLOUR);

  private final Map<String, Layer> byName = new HashMap<>();

  void add(DxfFields fields) {
    int colour = fields.integer(62, USUAL_COLOUR);
    byName.put(key(fields.name()), new Layer(colour < 0, fields.hasFlag(FROZEN), Math.abs(colour)));
  }

  private static String key(String name) {
    return name.toLowerCase(Locale.ROOT);
  }

  private Layer layer(String name) {
    return byName.getOrDefault(key(name), USUAL);
  }

  boolean isFrozen(String name) {
    return layer(name).isFrozen();
  }

  boolean isHidden(String name) {
    return layer(name).isOff() || layer(name).isFrozen();
  }

  int colour(String name) {
    return layer(name).colour();
  }
}
