package org.hificamsim.hifi.boxes;

import org.hificamsim.core.Texts;

/**
 * The effect of a box's width on the probability that a person is found: somebody who walks across
 * the picture fills a wider box than somebody who walks along the line of sight.
 *
 * @param slope the growth of the log odds per unit of the logarithm of width over height, 0 or more
 * @param usualShape the width over the height at which nothing is added, above 0; targets of a
 *     scenario have this shape, since they have no pose
 */
public record WidthEffect(double slope, double usualShape) {
  /** The effect of a width that does not matter. */
  public static final WidthEffect NONE = new WidthEffect(0, 1);

  /** Whether the width matters. */
  public boolean counts() {
    return slope > 0;
  }

  /** Returns the log odds that the shape of a box adds. */
  double logOdds(double pixels, double widthPixels) {
    return slope == 0 ? 0 : slope * StrictMath.log(widthPixels / pixels / usualShape);
  }

  /** Returns the term of the equation, with the width written as w; empty if there is none. */
  String equation() {
    return slope == 0 ? "" : Texts.format(" + %.3g ln(w / (%.3g px))", slope, usualShape);
  }
}
