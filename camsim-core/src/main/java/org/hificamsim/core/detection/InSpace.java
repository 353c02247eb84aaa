package org.hificamsim.core.detection;

import java.util.Optional;

/**
 * Evaluates a model at distances in space, given distances over the ground.
 *
 * @param model evaluated at distances in space
 * @param rise height of the camera above the part to be seen, metres
 * @param foreshortened whether an upright target seen from above looks shorter, by the cosine of
 *     the angle of depression: the weak perspective of Hartley and Zisserman, Multiple View
 *     Geometry (2004), section 6.3. The size is the root of the area, so it shrinks by the root of
 *     the cosine
 */
record InSpace(DetectionModel model, double rise, boolean foreshortened) implements DetectionModel {
  /** Keeps sizes above 0, since models take their logarithm. */
  private static final double MIN_COSINE = 1e-9;

  @Override
  public String name() {
    return model.name();
  }

  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    double slant = Math.sqrt(distance * distance + rise * rise);
    double apparentSize =
        foreshortened && slant > 0
            ? size * Math.sqrt(Math.max(distance / slant, MIN_COSINE))
            : size;
    return model.confidence(apparentSize, slant, offAxis, zoom);
  }

  @Override
  public double defaultThreshold() {
    return model.defaultThreshold();
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
  public Optional<Scatter> scatter() {
    return model.scatter();
  }
}
