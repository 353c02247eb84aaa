package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.hificamsim.profiling.measure.Measurement;

/** Synthetic photos whose PIPs follow a known law with known noise. */
final class Synthetic {
  static final double[] SIZES = {0.10, 0.12, 0.16, 0.22, 0.30, 0.40, 0.52, 0.66};
  static final double[] LENGTHS = {0.010, 0.015, 0.024, 0.050, 0.070, 0.085};

  private Synthetic() {}

  /** Computes {@code -log10(PIP)} by a law. */
  interface Law {
    double response(double q, double d, double z);
  }

  /** Returns 480 observations of a law with normal noise of this standard deviation. */
  static List<Measurement> of(Law law, double noise, long seed) {
    Random random = new Random(seed);
    List<Measurement> observations = new ArrayList<>();
    for (double q : SIZES) {
      for (double z : LENGTHS) {
        for (int d = 1; d <= 10; d++) {
          double y = law.response(q, d, z) + noise * random.nextGaussian();
          observations.add(photo(q, d, z, Math.pow(10, -y)));
        }
      }
    }
    return observations;
  }

  /** Returns a photo without confidences. */
  static Measurement photo(double size, double distance, double focalLength, double pip) {
    return new Measurement("photo", "object", size, distance, focalLength, pip, Map.of());
  }
}
