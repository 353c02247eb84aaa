package org.hificamsim.profiling.fit;

import java.util.List;
import java.util.TreeSet;
import org.hificamsim.profiling.measure.Measurement;

/**
 * CamSim's standard confidence {@code 0.95 (1 - r / rMax) - 0.15} (Eq 6.2) for the laboratory's
 * zooms. CamSim's zoom is a radius, which falls as the focal length grows; as thesis 6.2 says, its
 * values are computed with the focal lengths as radii and dealt out in reverse order.
 */
public final class CamSimConfidence {
  private static final double SLOPE = 0.95;
  private static final double LOSS = 0.15;

  private CamSimConfidence() {}

  /** The value for each measurement. */
  public static double[] of(List<Measurement> measurements) {
    List<Double> zooms =
        List.copyOf(new TreeSet<>(measurements.stream().map(Measurement::focalLength).toList()));
    double widest = zooms.get(zooms.size() - 1);
    return measurements.stream()
        .mapToDouble(
            m -> {
              double reversed = zooms.get(zooms.size() - 1 - zooms.indexOf(m.focalLength()));
              return SLOPE * (1 - reversed / widest) - LOSS;
            })
        .toArray();
  }
}
