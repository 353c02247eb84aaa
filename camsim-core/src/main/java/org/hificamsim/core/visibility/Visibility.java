package org.hificamsim.core.visibility;

import org.hificamsim.core.detection.DetectedDistances;
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
 *   <li>Line of sight: what is in between lets something of the target through.
 *   <li>Confidence: the detection model's {@linkplain #value value}.
 *   <li>Rule: the value, as much of it as gets through, is the threshold or more; or the
 *       {@linkplain #luck luck} of camera and target is below the chance of the value, as much as
 *       gets through.
 *   <li>Clamping: the {@linkplain #confidence confidence} is what the model {@linkplain
 *       DetectionModel#reported reports} for the value.
 * </ol>
 */
public final class Visibility {
  /** A cosine nearer to 0 is one of an angle between 0 and pi: rounding takes less than 1e-14. */
  private static final double BETWEEN = 1 - 1e-9;

  private final Detection detection;
  private final DetectionModel model;
  private final boolean asInCamSim;
  private final boolean certain;
  private final Luck luck;

  private Visibility(Detection detection, boolean asInCamSim, long seed) {
    this.detection = detection;
    this.model = detection.model();
    this.asInCamSim = asInCamSim;
    this.certain = detection.certain();
    this.luck = new Luck(seed, detection.rule().memory());
  }

  /** Where nothing is left to chance, or where one seed is as good as another. */
  public static Visibility of(Detection detection) {
    return of(detection, 0);
  }

  /**
   * The border of a sector belongs to it, and so does the camera's own position.
   *
   * @param seed of the run, which decides about its luck
   */
  public static Visibility of(Detection detection, long seed) {
    return new Visibility(detection, false, seed);
  }

  /** The same as {@link #asInCamSim(Detection, long)} where one seed is as good as another. */
  public static Visibility asInCamSim(Detection detection) {
    return asInCamSim(detection, 0);
  }

  /**
   * As in CamSim (behaviour 6.1 and 6.2): neither the border of a sector nor the camera's own
   * position belongs to it, and a target of confidence 0 is not seen.
   *
   * @param seed of the run, which decides about its luck
   */
  public static Visibility asInCamSim(Detection detection, long seed) {
    double threshold = Math.max(detection.threshold(), Double.MIN_VALUE);
    return new Visibility(
        detection.certain() ? new Detection(detection.model(), threshold) : detection, true, seed);
  }

  /** The detection model and the threshold, as this pipeline uses it. */
  public Detection detection() {
    return detection;
  }

  /**
   * The luck of a camera with a target in one step, for {@link #confidence}: in [0, 1), the same
   * whenever it is asked for; 0 by a threshold.
   */
  public double luck(long step, int camera, int target) {
    return certain ? 0 : luck.draw(step, camera, target);
  }

  /** How many targets a camera reports in a step that are not there: 0 or 1. */
  public int phantoms(long step, int camera) {
    double chance = detection.rule().phantoms();
    return chance > 0 && luck.draw(step, camera, -1) < chance ? 1 : 0;
  }

  /** The same as below with nothing in between. */
  public double confidence(
      Pose camera, ZoomLevel zoom, double x, double y, double size, double luck) {
    return confidence(camera, zoom, x, y, size, luck, 1);
  }

  /**
   * How sure a camera is of a target, see {@link #value}; 0 where it does not detect it.
   *
   * @param luck of the two in this step
   * @param transmittance how much of the target gets through what is in between, in [0, 1]
   */
  public double confidence(
      Pose camera,
      ZoomLevel zoom,
      double x,
      double y,
      double size,
      double luck,
      double transmittance) {
    double value = valueInSight(camera, zoom, x, y, size);
    if (!detection.detects(value, luck, transmittance)) {
      return 0;
    }
    double reported = model.reported(certain ? value * transmittance : value);
    return certain ? reported : Math.max(reported, Double.MIN_VALUE);
  }

  /** The same as below with nothing in between. */
  public double chance(Pose camera, ZoomLevel zoom, double x, double y, double size) {
    return chance(camera, zoom, x, y, size, 1);
  }

  /**
   * The chance that a camera detects a target, in [0, 1]; 1 or 0 by a threshold.
   *
   * @param transmittance how much of the target gets through what is in between, in [0, 1]
   */
  public double chance(
      Pose camera, ZoomLevel zoom, double x, double y, double size, double transmittance) {
    if (certain) {
      double value = valueInSight(camera, zoom, x, y, size);
      return detection.detects(value, 0, transmittance) ? 1 : 0;
    }
    return transmittance * chanceInTheOpen(camera, zoom, x, y, size);
  }

  private double chanceInTheOpen(Pose camera, ZoomLevel zoom, double x, double y, double size) {
    if (model.dependsOnBearing()) {
      double value = valueInSight(camera, zoom, x, y, size);
      return Double.isNaN(value) ? 0 : detection.chance(value);
    }
    double distance = camera.distance(x, y);
    return distance <= zoom.radius() && isInAngle(camera, zoom, x, y)
        ? detection.chances(size, zoom).chance(distance)
        : 0;
  }

  /**
   * The model's own value, whatever the threshold; 0 out of reach or angle.
   *
   * @param x the target's position, metres
   * @param y the target's position, metres
   * @param size the target's size, metres
   */
  public double value(Pose camera, ZoomLevel zoom, double x, double y, double size) {
    double value = valueInSight(camera, zoom, x, y, size);
    return Double.isNaN(value) ? 0 : value;
  }

  /** The same for a target that is within reach and angle, which is not tested. */
  public double valueInView(Pose camera, ZoomLevel zoom, double x, double y, double size) {
    double offAxis = model.dependsOnBearing() ? camera.offAxis(x, y) : 0;
    double value = model.confidence(size, camera.distance(x, y), offAxis, zoom);
    return Double.isNaN(value) ? 0 : value;
  }

  /** The value; NaN out of reach or angle. */
  private double valueInSight(Pose camera, ZoomLevel zoom, double x, double y, double size) {
    double distance = camera.distance(x, y);
    if (!(distance <= zoom.radius())) {
      return Double.NaN;
    }
    double offAxis = offAxis(camera, zoom, x, y, distance);
    return isWithin(camera, zoom, x, y, offAxis)
        ? model.confidence(size, distance, offAxis, zoom)
        : Double.NaN;
  }

  /**
   * The angle; any other between 0 and pi where that makes no difference, without a root.
   *
   * @param distance of the point, metres
   */
  private double offAxis(Pose camera, ZoomLevel zoom, double x, double y, double distance) {
    if (asInCamSim && !zoom.allRound()) {
      return camera.offAxis(x, y);
    }
    if (!model.dependsOnBearing()) {
      return 0;
    }
    boolean between = Math.abs(camera.along(x, y)) < BETWEEN * distance;
    return between && !model.dependsOnBearing(zoom) ? Math.PI / 2 : camera.offAxis(x, y);
  }

  /** Whether a point is within the opening angle at a zoom level. */
  public boolean isInAngle(Pose camera, ZoomLevel zoom, double x, double y) {
    return isWithin(camera, zoom, x, y, asInCamSim ? camera.offAxis(x, y) : 0);
  }

  /** The same, from the cosine of half the opening angle of a level that is not all round. */
  public boolean isInAngle(Pose camera, ZoomLevel zoom, double cosine, double x, double y) {
    return asInCamSim
        ? camera.offAxis(x, y) < zoom.viewingAngle() / 2
        : camera.isInCone(cosine, x, y);
  }

  /** The same where the angle is known, which CamSim's test alone looks at. */
  private boolean isWithin(Pose camera, ZoomLevel zoom, double x, double y, double offAxis) {
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
    if (model.dependsOnBearing() || !certain) {
      return zoom.equals(other);
    }
    return zoom.viewingAngle() >= other.viewingAngle()
        && detection.distances(size, zoom).includes(detection.distances(size, other));
  }

  /**
   * The distance beyond which a camera at this level detects no target of this size, as far as it
   * can be known, metres; {@linkplain #roundedUp rounded up}.
   */
  public double reach(ZoomLevel zoom, double size) {
    if (model.dependsOnBearing() || !certain) {
      return roundedUp(zoom.radius());
    }
    DetectedDistances distances = detection.distances(size, zoom);
    int intervals = distances.intervals();
    return intervals == 0 ? 0 : roundedUp(Math.sqrt(distances.to(intervals - 1)));
  }

  /**
   * A little more than a distance that a computed one, the root of a sum of squares, is at most: no
   * coordinate of the two points differs by more, whatever was rounded.
   *
   * @param distance metres
   */
  public static double roundedUp(double distance) {
    return distance * (1 + 1e-9) + 1e-150; // squares of less may be 0
  }
}
