package org.hificamsim.hifi.boxes;

import org.hificamsim.core.Texts;

/**
 * The probability that a detector finds a person, by the height of the person's box and the share
 * of it that is hidden:
 *
 * <pre>floor + (ceiling - floor) / (1 + exp(-(intercept + height ln(px / 100) - hidden h)))</pre>
 *
 * <p>It never falls with the height and never rises with the hidden share.
 *
 * @param intercept the log odds at 100 pixels and nothing hidden, between floor and ceiling
 * @param height the growth of the log odds per unit of the height's logarithm, 0 or more
 * @param hidden the loss of log odds from nothing hidden to everything hidden, 0 or more
 * @param floor the probability for a box of height 0, in [0, 1)
 * @param ceiling the probability in the limit of large boxes, in (floor, 1]
 */
public record FoundCurve(
    double intercept, double height, double hidden, double floor, double ceiling) {
  /** The height at which the intercept holds, pixels. */
  public static final double USUAL_PIXELS = 100;

  /**
   * Returns the probability, in [0, 1].
   *
   * @param pixels the height of the whole box, 0 or more, may be infinite
   * @param hiddenShare the hidden share of the box, in [0, 1]
   */
  public double found(double pixels, double hiddenShare) {
    double grown = height == 0 ? 0 : height * StrictMath.log(pixels / USUAL_PIXELS);
    double odds = StrictMath.exp(-(intercept + grown - hidden * hiddenShare));
    return floor + (ceiling - floor) / (1 + odds);
  }

  /** Returns the equation for readers, with the height written as px and the hidden share as h. */
  public String equation() {
    String logistic =
        Texts.format(
            "1 / (1 + exp(-(%.3g + %.3g ln(px / 100) - %.3g h)))", intercept, height, hidden);
    return floor == 0 && ceiling == 1
        ? logistic
        : Texts.format("%.3g + %.3g %s", floor, ceiling - floor, logistic.replaceFirst("^1 ", ""));
  }
}
