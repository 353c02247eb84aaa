package org.hificamsim.core.visibility;

import java.util.Optional;
import org.hificamsim.core.detection.ChanceTable;
import org.hificamsim.core.detection.DetectedDistances;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DistanceTable;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.detection.VerticalView;
import org.hificamsim.core.detection.ZoomLevel;

/**
 * What a camera sees of targets of one size at one zoom level: the steps of {@link Visibility}, and
 * all that can be found out about them before anything is looked at. Any number of threads may ask.
 *
 * <p>What is found out depends on the detection alone. Where the rule is a threshold and the model
 * ignores the bearing, the distances at which targets are detected decide, and the model is not
 * asked again; where the rule is one of chance, a table of chances by distance decides nearly all
 * draws. Otherwise the model is asked for each target in view.
 */
public final class LevelSight {
  /** A cosine nearer to 0 is one of an angle between 0 and pi: rounding takes less than 1e-14. */
  private static final double BETWEEN = 1 - 1e-9;

  /** Far more than what rounding does to a cosine, or to a square. */
  private static final double MARGIN = 1e-9;

  private final Detection detection;
  private final DetectionModel model;
  private final ZoomLevel zoom;
  private final Body body;
  private final double size;
  private final Footprint footprint; // null where nothing limits the view up and down
  private final boolean asInCamSim;
  private final boolean certain;
  private final boolean byDistance;
  private final boolean allRound;
  private final double cosine; // of half the opening angle
  private final double outside; // squared cosine with its sign, below which a point is outside
  private final double inside; // the same, above which it is inside
  private final DetectedDistances distances; // at which a target may be detected
  private final boolean single; // one interval, from 0 on
  private final double farthest; // squared, as in the distances; below 0 where there are none
  private final ChanceTable chances; // null where the model is asked, or distances decide
  private DistanceTable values; // made when first asked for

  LevelSight(Detection planar, boolean asInCamSim, ZoomLevel zoom, Body body) {
    VerticalView vertical = zoom.vertical();
    this.detection =
        vertical.flat()
            ? planar
            : planar.inSpace(vertical.z() - body.middle(), body.foreshortened());
    this.model = detection.model();
    this.body = body;
    this.size = body.size();
    this.footprint =
        Double.isNaN(vertical.angle()) ? null : Footprint.of(zoom, body.low(), body.high());
    this.asInCamSim = asInCamSim;
    this.zoom = zoom;
    this.certain = detection.certain();
    this.byDistance = certain && !model.dependsOnBearing();
    this.allRound = zoom.allRound();
    this.cosine = Math.cos(zoom.viewingAngle() / 2);
    this.outside = signedSquare(cosine - MARGIN);
    this.inside = signedSquare(cosine + MARGIN);
    this.distances =
        byDistance
            ? detection.distances(size, zoom)
            : DetectedDistances.of(new GeometricDetection(), size, zoom, 1);
    int intervals = distances.intervals();
    this.single = intervals == 1 && distances.from(0) == 0;
    this.farthest = intervals == 0 ? -1 : distances.to(intervals - 1);
    this.chances = byDistance || model.dependsOnBearing() ? null : detection.chances(size, zoom);
  }

  /** Whether this is the level's, for targets of a size in a flat world. */
  public boolean isOf(ZoomLevel level, double targetSize) {
    return zoom.equals(level) && size == targetSize;
  }

  /** What of targets has to be seen. */
  public Body body() {
    return body;
  }

  /** Where targets stand that are in the picture; empty where no upper and lower edge limit it. */
  public Optional<Footprint> footprint() {
    return Optional.ofNullable(footprint);
  }

  /** Whether no target is detected, wherever it stands. */
  public boolean isBlind() {
    return farthest < 0 || (footprint != null && footprint.isEmpty(reach()));
  }

  /** Whether distance and angle alone decide where nothing stands in between. */
  public boolean byDistance() {
    return byDistance;
  }

  /** Whether what may be detected is a whole disc around the camera. */
  public boolean isDisc() {
    return allRound && single;
  }

  /** The greatest squared distance at which a target may be detected; below 0 for none. */
  public double farthest() {
    return farthest;
  }

  /**
   * The distance beyond which no target is detected, as far as it can be known, metres; {@linkplain
   * Visibility#roundedUp rounded up}.
   */
  public double reach() {
    return farthest < 0 ? 0 : Visibility.roundedUp(Math.sqrt(farthest));
  }

  /**
   * Whether every target that a camera detects at the other level is proven to be detected at this
   * one, wherever both stand; they look the same way, and nothing is half transparent.
   */
  public boolean includes(LevelSight other) {
    return (byDistance && footprint == null)
        ? zoom.viewingAngle() >= other.zoom.viewingAngle() && distances.includes(other.distances)
        : zoom.equals(other.zoom);
  }

  /** Whether a target at a squared distance is near enough to be detected. */
  public boolean isInReach(double squared) {
    return single ? squared <= farthest : distances.contains(squared);
  }

  /** Whether a point is within the opening angle; of a lens with a height, in its picture. */
  public boolean isInAngle(Pose camera, double x, double y) {
    if (footprint != null) {
      return footprint.contains(camera.along(x, y), camera.aside(x, y));
    }
    if (allRound || !asInCamSim) {
      return allRound || camera.isInSector(cosine, x, y);
    }
    return isInCamSimsAngle(camera, x, y);
  }

  /** CamSim compares angles; squares tell most of them without a root or an arc cosine. */
  private boolean isInCamSimsAngle(Pose camera, double x, double y) {
    double squared = camera.squaredDistance(x, y);
    double signed = signedSquare(camera.along(x, y));
    if (signed < outside * squared) {
      return false;
    }
    boolean surely = signed > inside * squared && signed < BETWEEN * squared;
    return surely || camera.offAxis(x, y) < zoom.viewingAngle() / 2;
  }

  private static double signedSquare(double value) {
    return value * Math.abs(value);
  }

  /** Whether a target is in reach and angle, where it may be detected. */
  public boolean isInView(Pose camera, double x, double y) {
    return isInReach(camera.squaredDistance(x, y)) && isInAngle(camera, x, y);
  }

  /**
   * Whether a target that is in reach and angle is detected.
   *
   * @param squared distance to the target
   * @param luck of the camera and the target in this step
   * @param transmittance how much of the target gets through what is in between, in [0, 1]
   */
  public boolean detectsInView(
      Pose camera, double x, double y, double squared, double luck, double transmittance) {
    if (transmittance == 0 || (byDistance && transmittance == 1)) {
      return transmittance == 1;
    }
    return chances == null
        ? detection.detects(valueInView(camera, x, y), luck, transmittance)
        : chances.detects(Math.sqrt(squared), luck, transmittance);
  }

  /**
   * How sure a camera is of a target: what the model reports for its value; 0 where it does not
   * detect it.
   *
   * @param luck of the camera and the target in this step
   * @param transmittance how much of the target gets through what is in between, in [0, 1]
   */
  public double confidence(Pose camera, double x, double y, double luck, double transmittance) {
    return isInView(camera, x, y) ? confidenceInView(camera, x, y, luck, transmittance) : 0;
  }

  /** The same for a target that is in view, which is not tested. */
  public double confidenceInView(
      Pose camera, double x, double y, double luck, double transmittance) {
    double value = valueInView(camera, x, y);
    if (!detection.detects(value, luck, transmittance)) {
      return 0;
    }
    return certain
        ? model.reported(value * transmittance)
        : Math.max(model.reported(value), Double.MIN_VALUE);
  }

  /** The chance that a camera detects a target, in [0, 1]; 1 or 0 by a threshold. */
  public double chance(Pose camera, double x, double y, double transmittance) {
    if (!isInView(camera, x, y)) {
      return 0;
    }
    double squared = camera.squaredDistance(x, y);
    if (certain) {
      return detectsInView(camera, x, y, squared, 0, transmittance) ? 1 : 0;
    }
    if (chances != null) {
      return transmittance * chances.chance(Math.sqrt(squared));
    }
    double value = valueInView(camera, x, y);
    return Double.isNaN(value) ? 0 : transmittance * detection.chance(value);
  }

  /** The model's own value for a target in the field of view, whatever the threshold; else 0. */
  public double value(Pose camera, double x, double y) {
    double value =
        camera.distance(x, y) <= zoom.radius() && isInAngle(camera, x, y)
            ? valueInView(camera, x, y)
            : 0;
    return Double.isNaN(value) ? 0 : value;
  }

  /**
   * The same to about 1e-8 for a target that is in view, which is not tested.
   *
   * @param distance between the two, metres
   */
  public double value(Pose camera, double x, double y, double distance) {
    if (model.dependsOnBearing()) {
      return valueInView(camera, x, y);
    }
    DistanceTable table = values;
    if (table == null) { // two threads that come at once find the same one
      table = detection.values(size, zoom);
      values = table;
    }
    return table.value(distance);
  }

  private double valueInView(Pose camera, double x, double y) {
    double distance = camera.distance(x, y);
    return model.confidence(size, distance, offAxis(camera, x, y, distance), zoom);
  }

  /** The angle; any other between 0 and pi where that makes no difference, without a root. */
  private double offAxis(Pose camera, double x, double y, double distance) {
    if (!model.dependsOnBearing()) {
      return 0;
    }
    boolean between = Math.abs(camera.along(x, y)) < BETWEEN * distance;
    return between && !model.dependsOnBearing(zoom) ? Math.PI / 2 : camera.offAxis(x, y);
  }
}
