package org.hificamsim.hifi.boxes;

import org.hificamsim.core.Texts;

/**
 * The probability that a detector finds a person, by the height of the person's box and the share
 * of it that is hidden:
 *
 * <pre>floor + (ceiling - floor) / (1 + exp(-(intercept + height ln(px / 100) - hidden h)))</pre>
 *
 * <p>It never falls with the height and never rises with the hidden share. Boxes of another shape
 * than the usual one are found with another probability if there is a {@link WidthEffect}.
 *
 * @param intercept the log odds at 100 pixels and nothing hidden, between floor and ceiling
 * @param height the growth of the log odds per unit of the height's logarithm, 0 or more; the width
 *     grows as much
 * @param hidden the loss of log odds from nothing hidden to everything hidden, 0 or more
 * @param floor the probability for a box of height 0, in [0, 1)
 * @param ceiling the probability in the limit of large boxes, in (floor, 1]
 * @param width the effect of the width, whose slope is at most {@code height}
 */
public record FoundCurve(
    double intercept,
    double height,
    double hidden,
    double floor,
    double ceiling,
    WidthEffect width) {
  /** The height at which the intercept holds, in pixels. */
  public static final double USUAL_PIXELS = 100;

  /** Creates a curve that ignores the width. */
  public FoundCurve(double intercept, double height, double hidden, double floor, double ceiling) {
    this(intercept, height, hidden, floor, ceiling, WidthEffect.NONE);
  }

  /**
   * Returns the probability for a box of the usual shape, in [0, 1].
   *
   * @param pixels the height of the whole box, 0 or more, may be infinite
   * @param hiddenShare the hidden share of the box, in [0, 1]
   */
  public double found(double pixels, double hiddenShare) {
    return probability(pixels, hiddenShare, 0);
  }

  /**
   * Returns the probability for a box of any shape, in [0, 1].
   *
   * @param pixels the height of the whole box, above 0
   * @param widthPixels the width of the whole box, above 0
   * @param hiddenShare the hidden share of the box, in [0, 1]
   */
  public double found(double pixels, double widthPixels, double hiddenShare) {
    return probability(pixels, hiddenShare, width.logOdds(pixels, widthPixels));
  }

  private double probability(double pixels, double hiddenShare, double byShape) {
    double grown = height == 0 ? 0 : height * StrictMath.log(pixels / USUAL_PIXELS);
    double odds = StrictMath.exp(-(intercept + grown + byShape - hidden * hiddenShare));
    return floor + (ceiling - floor) / (1 + odds);
  }

  /** Returns the equation for readers: px is the height, w the width, h the hidden share. */
  public String equation() {
    String logistic =
        Texts.format(
            "1 / (1 + exp(-(%.3g + %.3g ln(px / 100) - %.3g h%s)))",
            intercept, height, hidden, width.equation());
    return floor == 0 && ceiling == 1
        ? logistic
        : Texts.format("%.3g + %.3g %s", floor, ceiling - floor, logistic.replaceFirst("^1 ", ""));
  }
}
