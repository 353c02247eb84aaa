package org.hificamsim.tracks.place;

import java.util.List;
import org.hificamsim.core.Place;

/**
 * A shape of a drawing with its height.
 *
 * @param height the height in metres; infinite if the drawing has none
 */
record DrawnPart(DrawnShape shape, double height) {
  /** The height and the labels that a drawing gives to a shape. */
  record Traits(double height, List<Label> labels) {
    static final Traits NONE = new Traits(Double.POSITIVE_INFINITY, List.of());

    Traits withHeight(double metres) {
      return new Traits(metres, labels);
    }
  }

  /**
   * Reads a height with or without a unit.
   *
   * @throws org.hificamsim.core.InputException if it is none, or not above 0
   */
  static double height(Place place, String text) {
    return height(
        place,
        HeightText.metres(text)
            .orElseThrow(
                () -> place.invalid("height", text, "a height such as 12, 12 m, 39 ft or 39'4\"")));
  }

  /**
   * Returns a height that a file has, in metres.
   *
   * @throws org.hificamsim.core.InputException if it is not above 0
   */
  static double height(Place place, double metres) {
    if (!(metres > 0 && metres <= 1e9)) {
      throw place.error("height is " + metres + ", expected a number above 0 and at most 1e9 (m)");
    }
    return metres;
  }
}
