package org.hificamsim.core.detection;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Evaluates a model at distances in space, given distances over the ground.
 *
 * @param model the model, which is evaluated at distances in space
 * @param rise the height of the camera above the part to be seen, in metres
 * @param foreshortened whether an upright target seen from above looks shorter, by the cosine of
 *     the angle of depression: the weak perspective of Hartley and Zisserman, Multiple View
 *     Geometry (2004), section 6.3. The size is the root of the area, so it shrinks by the root of
 *     the cosine
 */
record InSpace(DetectionModel model, double rise, boolean foreshortened) implements DetectionModel {
  /** The least cosine, which keeps sizes above 0, since models take their logarithm. */
  private static final double MIN_COSINE = 1e-9;

  @Override
  public String name() {
    return model.name();
  }

  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    double slant = Math.sqrt(distance * distance + rise * rise);
    return model.confidence(
        apparentSize(size, distance, slant, zoom.vertical()), slant, offAxis, zoom);
  }

  @Override
  public double confidence(
      double size, double distance, double offAxis, ZoomLevel zoom, double hiddenShare) {
    double slant = Math.sqrt(distance * distance + rise * rise);
    return model.confidence(
        apparentSize(size, distance, slant, zoom.vertical()), slant, offAxis, zoom, hiddenShare);
  }

  private double apparentSize(double size, double distance, double slant, VerticalView view) {
    if (model.byHeight()) {
      return slant * view.heightInPicture(distance, size);
    }
    return foreshortened && slant > 0
        ? size * Math.sqrt(Math.max(distance / slant, MIN_COSINE))
        : size;
  }

  @Override
  public boolean dependsOnHiddenShare() {
    return model.dependsOnHiddenShare();
  }

  @Override
  public boolean byHeight() {
    return model.byHeight();
  }

  @Override
  public DetectionRule defaultRule() {
    return model.defaultRule();
  }

  @Override
  public OptionalDouble phantoms() {
    return model.phantoms();
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
