package org.hificamsim.core.detection;

/**
 * The chance that a target of one size is detected at one zoom level, by distance: found once, so
 * that a draw is decided without asking the model in all but about a hundredth of all cases.
 *
 * <p>The distances from 0 to the radius are cut into {@value #BINS} equal bins. Of each bin the
 * least and the greatest chance are kept, of {@value #SAMPLES} samples each; between two samples a
 * chance is taken to leave that range by no more than a tenth of its width. A draw in the range
 * asks the model in full: the result is what the model alone would give.
 */
public final class ChanceTable {
  private static final int BINS = 256;
  private static final int SAMPLES = 16;
  private static final double MARGIN = 0.1;
  private static final float ROUNDING = 1e-9f;

  private final Detection detection;
  private final double size;
  private final ZoomLevel zoom;
  private final double binsPerMetre;
  private final float[] least = new float[BINS];
  private final float[] greatest = new float[BINS];

  ChanceTable(Detection detection, double size, ZoomLevel zoom) {
    this.detection = detection;
    this.size = size;
    this.zoom = zoom;
    this.binsPerMetre = BINS / zoom.radius();
    for (int bin = 0; bin < BINS; bin++) {
      sample(bin);
    }
  }

  private void sample(int bin) {
    double low = 1;
    double high = 0;
    for (int i = 0; i <= SAMPLES; i++) {
      double share = (bin + (double) i / SAMPLES) / BINS;
      double chance = chance(zoom.radius() * share);
      low = Math.min(low, chance);
      high = Math.max(high, chance);
    }
    double margin = MARGIN * (high - low) + ROUNDING;
    least[bin] = Math.nextDown((float) (low - margin));
    greatest[bin] = Math.nextUp((float) (high + margin));
  }

  /**
   * Whether a target is detected.
   *
   * @param distance to it, metres; within the radius
   * @param luck in [0, 1)
   */
  public boolean detects(double distance, double luck) {
    int bin = Math.min((int) (distance * binsPerMetre), BINS - 1);
    if (luck < least[bin]) {
      return true;
    }
    return luck < greatest[bin] && luck < chance(distance);
  }

  private double chance(double distance) {
    double chance = detection.chance(detection.model().confidence(size, distance, 0, zoom));
    return chance > 0 ? chance : 0;
  }
}
