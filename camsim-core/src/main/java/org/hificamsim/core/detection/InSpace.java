package org.hificamsim.core.detection;

import java.util.Optional;

/**
 * A model that is asked by distances over the ground, and is given those in space.
 *
 * @param model whose distances are those in space
 * @param rise from what has to be seen to the camera, metres
 * @param foreshortened whether an upright target that is seen from above looks shorter, by the
 *     cosine of the angle of depression: the weak perspective of Hartley and Zisserman, Multiple
 *     View Geometry (2004), section 6.3. Its size is the root of its area, so it falls with the
 *     root of the cosine
 */
record InSpace(DetectionModel model, double rise, boolean foreshortened) implements DetectionModel {
  /** A target of no size has no logarithm. */
  private static final double LEAST_COSINE = 1e-9;

  @Override
  public String name() {
    return model.name();
  }

  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    double slant = Math.sqrt(distance * distance + rise * rise);
    double shown =
        foreshortened && slant > 0
            ? size * Math.sqrt(Math.max(distance / slant, LEAST_COSINE))
            : size;
    return model.confidence(shown, slant, offAxis, zoom);
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
