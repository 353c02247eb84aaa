package org.hificamsim.tracks.place;

import java.nio.file.Path;
import org.hificamsim.core.InputException;

/** The scale of a drawing or picture. */
public sealed interface PlanScale {
  /**
   * Metres per pixel, or per unit of the drawing.
   *
   * @param metres above 0
   */
  record PerUnit(double metres) implements PlanScale {}

  /**
   * The scale of a paper, such as 1:100.
   *
   * @param ratio ratio of real to drawn lengths, above 0
   */
  record Paper(double ratio) implements PlanScale {}

  /**
   * The width of the whole drawing or picture.
   *
   * @param metres above 0
   */
  record Width(double metres) implements PlanScale {
    /**
     * Returns the metres of a unit.
     *
     * @param units the width in units of the drawing
     * @throws InputException if that is not above 0
     */
    double perUnit(Path file, double units) {
      if (!(units > 0)) {
        throw InputException.of(
            "%s: what is drawn has no width, expected walls side by side", file);
      }
      return metres / units;
    }
  }
}
