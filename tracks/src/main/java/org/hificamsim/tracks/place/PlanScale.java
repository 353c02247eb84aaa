package org.hificamsim.tracks.place;

import java.nio.file.Path;
import org.hificamsim.core.InputException;

/** How large the things of a drawing or picture are in reality. */
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
   * @param ratio how many times larger the real things are, above 0
   */
  record Paper(double ratio) implements PlanScale {}

  /**
   * The width of all that is drawn, or of the picture.
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
