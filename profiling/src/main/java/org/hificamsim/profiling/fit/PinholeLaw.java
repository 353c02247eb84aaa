package org.hificamsim.profiling.fit;

import java.util.List;
import org.hificamsim.hifi.feature.PinholeAbstraction;

/**
 * The pinhole camera, which fits nothing: for comparison.
 *
 * @param sensorWidth metres
 * @param sensorHeight metres
 */
public record PinholeLaw(double sensorWidth, double sensorHeight) implements FeatureRegression {
  @Override
  public String name() {
    return "pinhole";
  }

  @Override
  public FittedFeature fit(List<Observation> observations) {
    return new FittedFeature(
        new PinholeAbstraction(sensorWidth, sensorHeight),
        "PIP = (z q / d)^2 / sensor area",
        List.of());
  }
}
