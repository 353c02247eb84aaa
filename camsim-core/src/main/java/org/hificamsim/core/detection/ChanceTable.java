package org.hificamsim.core.detection;

/**
 * The chance by distance that a target of one size is detected at one zoom level. Computed once, so
 * that draws and expectations rarely evaluate the model.
 *
 * <p>Each bin of a {@link DistanceTable} keeps the least and the greatest chance of its samples;
 * between two samples, a chance is assumed to leave that range by at most a tenth of its width. A
 * draw within the range evaluates the model, so that all draws are decided exactly as by the model.
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
    this.chances = new DistanceTable(zoom.radius(), this::exactChance, this::bracket);
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
   * @param distance the distance to the target, in metres, at most the radius
   * @param luck the luck, in [0, 1)
   * @param transmittance the part of the target's light that reaches the camera, in [0, 1]
   */
  public boolean detects(double distance, double luck, double transmittance) {
    if (transmittance < 1) {
      return luck < transmittance * exactChance(distance);
    }
    int bin = chances.bin(distance);
    if (luck < least[bin]) {
      return true;
    }
    return luck < greatest[bin] && luck < exactChance(distance);
  }

  /**
   * The chance that a target is detected, to about 1e-8, in [0, 1].
   *
   * @param distance the distance to the target, in metres, at most the radius
   */
  public double chance(double distance) {
    return Math.max(0, Math.min(1, chances.value(distance)));
  }

  private double exactChance(double distance) {
    double chance = detection.chance(detection.model().confidence(size, distance, 0, zoom));
    return chance > 0 ? chance : 0;
  }
}
