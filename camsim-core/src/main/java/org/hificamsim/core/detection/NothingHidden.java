package org.hificamsim.core.detection;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Evaluates a model as if no target were partly hidden, for callers that do not know where targets
 * will be. Obstacles hide as they do for models that do not depend on hidden shares.
 */
public record NothingHidden(DetectionModel model) implements DetectionModel {
  @Override
  public String name() {
    return model.name();
  }

  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    return model.confidence(size, distance, offAxis, zoom);
  }

  @Override
  public boolean byHeight() {
    return model.byHeight();
  }

  @Override
  public double defaultThreshold() {
    return model.defaultThreshold();
  }

  @Override
  public DetectionRule defaultRule() {
    return model.defaultRule();
  }

  @Override
  public boolean dependsOnBearing() {
    return model.dependsOnBearing();
  }

  @Override
  public boolean dependsOnBearing(ZoomLevel zoom) {
    return model.dependsOnBearing(zoom);
  }

  @Override
  public double reported(double value) {
    return model.reported(value);
  }

  @Override
  public boolean flat() {
    return model.flat();
  }

  @Override
  public Seen seen() {
    return model.seen();
  }

  @Override
  public Optional<Scatter> scatter() {
    return model.scatter();
  }

  @Override
  public OptionalDouble phantoms() {
    return model.phantoms();
  }
}
