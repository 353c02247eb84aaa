package org.hificamsim.core.visibility;

import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;

/**
 * What a camera sees of a target, one pair at a time. The engine, CamSim's network and the agent
 * inside CamSim share this pipeline; what the engine does faster gives the same answers.
 *
 * <ol>
 *   <li>Reach: the target is not farther away than the zoom level's radius.
 *   <li>Angle: it is {@linkplain #isInAngle within the opening angle}.
 *   <li>Confidence: the detection model's {@linkplain #value value}.
 *   <li>Threshold: the value is the threshold or more.
 *   <li>Clamping: the {@linkplain #confidence confidence} is what the model {@linkplain
 *       DetectionModel#reported reports} for the value.
 * </ol>
 */
public final class Visibility {
  private final Detection detection;
  private final DetectionModel model;
  private final boolean asInCamSim;

  private Visibility(Detection detection, boolean asInCamSim) {
    this.detection = detection;
    this.model = detection.model();
    this.asInCamSim = asInCamSim;
  }

  /** The border of a sector belongs to it, and so does the camera's own position. */
  public static Visibility of(Detection detection) {
    return new Visibility(detection, false);
  }

  /**
   * As in CamSim (behaviour 6.1 and 6.2): neither the border of a sector nor the camera's own
   * position belongs to it, and a target of confidence 0 is not seen.
   */
  public static Visibility asInCamSim(Detection detection) {
    double threshold = Math.max(detection.threshold(), Double.MIN_VALUE);
    return new Visibility(new Detection(detection.model(), threshold), true);
  }

  /** The detection model and the threshold, as this pipeline uses it. */
  public Detection detection() {
    return detection;
  }

  /** How sure a camera is of a target, see {@link #value}; 0 where it does not detect it. */
  public double confidence(Pose camera, ZoomLevel zoom, double x, double y, double size) {
    double value = value(camera, zoom, x, y, size);
    return value >= detection.threshold() ? model.reported(value) : 0;
  }

  /**
   * The model's own value, whatever the threshold; 0 out of reach or angle.
   *
   * @param x the target's position, metres
   * @param y the target's position, metres
   * @param size the target's size, metres
   */
  public double value(Pose camera, ZoomLevel zoom, double x, double y, double size) {
    double distance = camera.distance(x, y);
    if (!(distance <= zoom.radius())) {
      return 0;
    }
    boolean byAngle = model.dependsOnBearing() || (asInCamSim && !zoom.allRound());
    double offAxis = byAngle ? camera.offAxis(x, y) : 0;
    return isInAngle(camera, zoom, x, y, offAxis)
        ? model.confidence(size, distance, offAxis, zoom)
        : 0;
  }

  /** Whether a point is within the opening angle at a zoom level. */
  public boolean isInAngle(Pose camera, ZoomLevel zoom, double x, double y) {
    return isInAngle(camera, zoom, x, y, asInCamSim ? camera.offAxis(x, y) : 0);
  }

  /** The same where the angle is known, which CamSim's test alone looks at. */
  private boolean isInAngle(Pose camera, ZoomLevel zoom, double x, double y, double offAxis) {
    if (zoom.allRound()) {
      return true;
    }
    return asInCamSim
        ? offAxis < zoom.viewingAngle() / 2
        : camera.isInSector(zoom.viewingAngle(), x, y);
  }

  /**
   * Whether a camera at one level is proven to detect every target of this size that it would
   * detect at the other level, wherever it stands.
   */
  public boolean dominates(ZoomLevel zoom, ZoomLevel other, double size) {
    if (model.dependsOnBearing()) {
      return zoom.equals(other);
    }
    return zoom.viewingAngle() >= other.viewingAngle()
        && detection.distances(size, zoom).includes(detection.distances(size, other));
  }
}
