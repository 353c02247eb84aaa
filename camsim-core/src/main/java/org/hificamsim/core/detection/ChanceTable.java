package org.hificamsim.core.detection;

/**
 * The chance that a target of one size is detected at one zoom level, by distance: found once, so
 * that neither a draw nor an expectation has to ask the model in nearly all cases.
 *
 * <p>The distances from 0 to the radius are cut into {@value #BINS} equal bins. A bin has a cubic
 * through four of its {@value #SAMPLES} samples and one more; where that misses none of the others
 * by more than {@value #TOLERANCE}, it stands for the {@linkplain #chance chance}. For draws a bin
 * keeps the least and the greatest chance of its samples; between two samples a chance is taken to
 * leave that range by no more than a tenth of its width. A draw within the range asks the model in
 * full: it is decided as the model alone would.
 */
public final class ChanceTable {
  private static final int BINS = 512;
  private static final int SAMPLES = 12;
  private static final int TERMS = 4;
  private static final double TOLERANCE = 5e-9;
  private static final double MARGIN = 0.1;
  private static final double ROUNDING = 1e-9;

  private final Detection detection;
  private final double size;
  private final ZoomLevel zoom;
  private final double binsPerMetre;
  private final float[] least = new float[BINS];
  private final float[] greatest = new float[BINS];
  private final double[] cubic = new double[BINS * TERMS];

  ChanceTable(Detection detection, double size, ZoomLevel zoom) {
    this.detection = detection;
    this.size = size;
    this.zoom = zoom;
    this.binsPerMetre = BINS / zoom.radius();
    double[] samples = new double[SAMPLES + 1];
    for (int bin = 0; bin < BINS; bin++) {
      for (int i = 0; i <= SAMPLES; i++) {
        samples[i] = inFull(zoom.radius() * ((bin + (double) i / SAMPLES) / BINS));
      }
      bracket(bin, samples);
      interpolate(bin, samples);
    }
  }

  private void bracket(int bin, double[] samples) {
    double low = 1;
    double high = 0;
    for (double chance : samples) {
      low = Math.min(low, chance);
      high = Math.max(high, chance);
    }
    double margin = MARGIN * (high - low) + ROUNDING;
    least[bin] = Math.nextDown((float) (low - margin));
    greatest[bin] = Math.nextUp((float) (high + margin));
  }

  /** Newton's forward differences over thirds of the bin; NaN where the cubic is not close. */
  private void interpolate(int bin, double[] samples) {
    int third = SAMPLES / 3;
    double first = samples[third] - samples[0];
    double second = samples[2 * third] - samples[third];
    double last = samples[SAMPLES] - samples[2 * third];
    int at = bin * TERMS;
    cubic[at] = samples[0];
    cubic[at + 1] = first;
    cubic[at + 2] = (second - first) / 2;
    cubic[at + 3] = (last - 2 * second + first) / 6;
    for (int i = 0; i <= SAMPLES; i++) {
      if (!(Math.abs(cubic(at, 3.0 * i / SAMPLES) - samples[i]) <= TOLERANCE)) {
        cubic[at] = Double.NaN;
        return;
      }
    }
  }

  /**
   * The cubic of a bin.
   *
   * @param s thirds of the bin, [0, 3]
   */
  private double cubic(int at, double s) {
    double sum = cubic[at + 2] + (s - 2) * cubic[at + 3];
    return cubic[at] + s * (cubic[at + 1] + (s - 1) * sum);
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
    return luck < greatest[bin] && luck < inFull(distance);
  }

  /** The same where something in between lets only a part of the chance through. */
  public boolean detects(double distance, double luck, double transmittance) {
    return transmittance == 1 ? detects(distance, luck) : luck < transmittance * inFull(distance);
  }

  /**
   * The chance that a target is detected, to about twice {@value #TOLERANCE}, in [0, 1].
   *
   * @param distance to it, metres; within the radius
   */
  public double chance(double distance) {
    double bins = distance * binsPerMetre;
    int bin = Math.min((int) bins, BINS - 1);
    double chance = cubic(bin * TERMS, 3 * (bins - bin));
    return Double.isNaN(chance) ? inFull(distance) : Math.max(0, Math.min(1, chance));
  }

  private double inFull(double distance) {
    double chance = detection.chance(detection.model().confidence(size, distance, 0, zoom));
    return chance > 0 ? chance : 0;
  }
}
