package org.hificamsim.core.detection;

/**
 * The chance that a target of one size is detected at one zoom level, by distance: found once, so
 * that neither a draw nor an expectation has to ask the model in nearly all cases.
 *
 * <p>For draws each bin of a {@link DistanceTable} keeps the least and the greatest chance of its
 * samples; between two samples a chance is taken to leave that range by no more than a tenth of its
 * width. A draw within the range asks the model in full: it is decided as the model alone would.
 */
public final class ChanceTable {
  private static final double MARGIN = 0.1;
  private static final double ROUNDING = 1e-9;

  private final Detection detection;
  private final double size;
  private final ZoomLevel zoom;
  private final float[] least = new float[DistanceTable.MAX_BINS];
  private final float[] greatest = new float[DistanceTable.MAX_BINS];
  private final DistanceTable chances;

  ChanceTable(Detection detection, double size, ZoomLevel zoom) {
    this.detection = detection;
    this.size = size;
    this.zoom = zoom;
    this.chances = new DistanceTable(zoom.radius(), this::inFull, this::bracket);
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

  /**
   * Whether a target is detected.
   *
   * @param distance to it, metres; within the radius
   * @param luck in [0, 1)
   * @param transmittance the part of the chance that what is in between lets through, in [0, 1]
   */
  public boolean detects(double distance, double luck, double transmittance) {
    if (transmittance < 1) {
      return luck < transmittance * inFull(distance);
    }
    int bin = chances.bin(distance);
    if (luck < least[bin]) {
      return true;
    }
    return luck < greatest[bin] && luck < inFull(distance);
  }

  /**
   * The chance that a target is detected, to about 1e-8, in [0, 1].
   *
   * @param distance to it, metres; within the radius
   */
  public double chance(double distance) {
    return Math.max(0, Math.min(1, chances.value(distance)));
  }

  private double inFull(double distance) {
    double chance = detection.chance(detection.model().confidence(size, distance, 0, zoom));
    return chance > 0 ? chance : 0;
  }
}
