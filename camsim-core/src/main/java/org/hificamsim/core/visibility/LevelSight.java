package org.hificamsim.core.visibility;

import java.util.Optional;
import org.hificamsim.core.detection.ChanceTable;
import org.hificamsim.core.detection.DetectedDistances;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DistanceTable;
import org.hificamsim.core.detection.VerticalView;
import org.hificamsim.core.detection.ZoomLevel;

/**
 * Decides what a camera sees of targets with one body at one zoom level: the steps of {@link
 * Visibility}, with all that depends on the detection alone computed in advance. Safe for use by
 * several threads.
 *
 * <p>If the rule is a threshold and the model ignores the bearing, precomputed distances decide,
 * and the model is not evaluated again. If the rule is one of chance, a table of chances by
 * distance decides nearly all draws. Otherwise the model is evaluated for each target in view.
 */
public final class LevelSight {
  /**
   * The greatest cosine that surely belongs to an angle above 0, in spite of rounding (less than
   * 1e-14).
   */
  private static final double MAX_SAFE_COSINE = 1 - 1e-9;

  /** A bound far above the rounding error of a cosine or of a square. */
  private static final double MARGIN = 1e-9;

  private final Detection detection;
  private final DetectionModel model;
  private final ZoomLevel zoom;
  private final Body body;
  private final double size;

  /** The ground in the picture; null if the lens has no vertical angle. */
  private final Footprint footprint;

  private final boolean asInCamSim;
  private final boolean certain;
  private final boolean byDistance;
  private final boolean allRound;
  private final double cosineOfHalfAngle;

  /** The signed squared cosine below which a point is outside the opening angle. */
  private final double outsideBelow;

  /** The signed squared cosine above which a point is inside the opening angle. */
  private final double insideAbove;

  private final DetectedDistances detectedDistances;

  /** Whether the detected distances are one interval from 0. */
  private final boolean singleInterval;

  /** The greatest squared distance that may be detected; below 0 if there is none. */
  private final double farthestSquared;

  /** The tabulated chances; null if distances decide, or the model has to be evaluated. */
  private final ChanceTable chances;

  /** The tabulated values of the model; null before they are first used. */
  private DistanceTable values;

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
    boolean hiddenByDegrees = model.dependsOnHiddenShare();
    this.byDistance = certain && !model.dependsOnBearing() && !hiddenByDegrees;
    this.allRound = zoom.allRound();
    this.cosineOfHalfAngle = Math.cos(zoom.viewingAngle() / 2);
    this.outsideBelow = signedSquare(cosineOfHalfAngle - MARGIN);
    this.insideAbove = signedSquare(cosineOfHalfAngle + MARGIN);
    this.detectedDistances =
        byDistance ? detection.distances(size, zoom) : detection.distancesInView(size, zoom);
    int intervals = detectedDistances.intervals();
    this.singleInterval = intervals == 1 && detectedDistances.from(0) == 0;
    this.farthestSquared = intervals == 0 ? -1 : detectedDistances.to(intervals - 1);
    boolean byTable = !certain && !model.dependsOnBearing();
    this.chances = byTable ? detection.chances(size, zoom) : null;
  }

  /** The part of targets that must be seen. */
  public Body body() {
    return body;
  }

  /**
   * Returns the ground on which targets in the picture stand; empty if the lens has no vertical
   * angle.
   */
  public Optional<Footprint> footprint() {
    return Optional.ofNullable(footprint);
  }

  /** Whether no target is detected at any position. */
  public boolean isBlind() {
    return farthestSquared < 0 || (footprint != null && footprint.isEmpty(reach()));
  }

  /** Whether distance and angle alone decide, if nothing stands in between. */
  public boolean byDistance() {
    return byDistance;
  }

  /** Whether targets may be detected in a whole disc around the camera. */
  public boolean isDisc() {
    return allRound && singleInterval;
  }

  /** The greatest squared distance at which a target may be detected; below 0 for none. */
  public double farthestSquared() {
    return farthestSquared;
  }

  /**
   * A distance in metres beyond which no target is detected, {@linkplain Visibility#roundedUp
   * rounded up}.
   */
  public double reach() {
    return farthestSquared < 0 ? 0 : Visibility.roundedUp(Math.sqrt(farthestSquared));
  }

  /**
   * Whether this level provably detects every target that the other level detects, at any position,
   * if both look the same way and no obstacle is partly transparent.
   */
  public boolean includes(LevelSight other) {
    return (byDistance && footprint == null)
        ? zoom.viewingAngle() >= other.zoom.viewingAngle()
            && detectedDistances.includes(other.detectedDistances)
        : zoom.equals(other.zoom);
  }

  /** Whether a target at a squared distance may be detected. */
  public boolean isInReach(double squared) {
    return singleInterval ? squared <= farthestSquared : detectedDistances.contains(squared);
  }

  /** Whether a point is within the opening angle, or in the picture of a lens with a height. */
  public boolean isInAngle(Pose camera, double x, double y) {
    if (footprint != null) {
      return footprint.contains(camera.along(x, y), camera.aside(x, y));
    }
    if (allRound || !asInCamSim) {
      return allRound || camera.isInSector(cosineOfHalfAngle, x, y);
    }
    return isInCamSimsAngle(camera, x, y);
  }

  /** Compares angles like CamSim; squares decide most cases without a root or an arc cosine. */
  private boolean isInCamSimsAngle(Pose camera, double x, double y) {
    double squared = camera.squaredDistance(x, y);
    double signed = signedSquare(camera.along(x, y));
    if (signed < outsideBelow * squared) {
      return false;
    }
    boolean certainlyInside = signed > insideAbove * squared && signed < MAX_SAFE_COSINE * squared;
    return certainlyInside || camera.offAxis(x, y) < zoom.viewingAngle() / 2;
  }

  private static double signedSquare(double value) {
    return value * Math.abs(value);
  }

  /** Whether a target is in reach and angle. */
  public boolean isInView(Pose camera, double x, double y) {
    return isInReach(camera.squaredDistance(x, y)) && isInAngle(camera, x, y);
  }

  /**
   * Whether a target that is in reach and angle is detected.
   *
   * @param squared distance to the target
   * @param luck the luck of the camera and the target in this step
   * @param transmittance the part of the target's light that reaches the camera, in [0, 1]
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
   * The same as {@link #detectsInView(Pose, double, double, double, double, double)} for a target
   * that is partly hidden.
   *
   * @param hidden the share of the target that is hidden, in [0, 1]; 0 unless the model depends on
   *     it
   */
  public boolean detectsInView(
      Pose camera,
      double x,
      double y,
      double squared,
      double luck,
      double transmittance,
      double hidden) {
    return hidden == 0
        ? detectsInView(camera, x, y, squared, luck, transmittance)
        : detection.detects(valueInView(camera, x, y, hidden), luck, transmittance);
  }

  /**
   * The confidence that the model reports for a target; 0 if the camera does not detect it.
   *
   * @param luck the luck of the camera and the target in this step
   * @param transmittance the part of the target's light that reaches the camera, in [0, 1]
   */
  public double confidence(Pose camera, double x, double y, double luck, double transmittance) {
    return isInView(camera, x, y) ? confidenceInView(camera, x, y, luck, transmittance) : 0;
  }

  /** The {@link #confidence} for a target that is known to be in view. */
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

  /** The chance that a camera detects a target, in [0, 1]; 1 or 0 under a threshold. */
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

  /**
   * The same as {@link #chance(Pose, double, double, double)} for a target that is partly hidden.
   *
   * @param hidden the share of the target that is hidden, in [0, 1]; 0 unless the model depends on
   *     it
   */
  public double chance(Pose camera, double x, double y, double transmittance, double hidden) {
    if (hidden == 0 || !isInView(camera, x, y)) {
      return chance(camera, x, y, transmittance);
    }
    double value = valueInView(camera, x, y, hidden);
    if (certain) {
      return detection.detects(value, 0, transmittance) ? 1 : 0;
    }
    return Double.isNaN(value) ? 0 : transmittance * detection.chance(value);
  }

  /**
   * The same as {@link #value(Pose, double, double)} for a target that is partly hidden.
   *
   * @param hidden the share of the target that is hidden, in [0, 1]; 0 unless the model depends on
   *     it
   */
  public double valueWhenHidden(Pose camera, double x, double y, double hidden) {
    if (hidden == 0 || value(camera, x, y) == 0) {
      return value(camera, x, y);
    }
    double value = valueInView(camera, x, y, hidden);
    return Double.isNaN(value) ? 0 : value;
  }

  /** The model's value for a target in the field of view, independent of the threshold; else 0. */
  public double value(Pose camera, double x, double y) {
    double value =
        camera.distance(x, y) <= zoom.radius() && isInAngle(camera, x, y)
            ? valueInView(camera, x, y)
            : 0;
    return Double.isNaN(value) ? 0 : value;
  }

  /**
   * The {@link #value(Pose, double, double)} to about 1e-8 for a target that is known to be in
   * view.
   *
   * @param distance the distance from the camera to the target, in metres
   */
  public double value(Pose camera, double x, double y, double distance) {
    if (model.dependsOnBearing()) {
      return valueInView(camera, x, y);
    }
    DistanceTable table = values;
    if (table == null) { // threads that race here compute equal tables
      table = detection.values(size, zoom);
      values = table;
    }
    return table.value(distance);
  }

  private double valueInView(Pose camera, double x, double y) {
    double distance = camera.distance(x, y);
    return model.confidence(size, distance, offAxis(camera, x, y, distance), zoom);
  }

  private double valueInView(Pose camera, double x, double y, double hidden) {
    double distance = camera.distance(x, y);
    return model.confidence(size, distance, offAxis(camera, x, y, distance), zoom, hidden);
  }

  /** The angle off the axis, or any angle between 0 and pi if the model ignores which one it is. */
  private double offAxis(Pose camera, double x, double y, double distance) {
    if (!model.dependsOnBearing()) {
      return 0;
    }
    boolean offTheAxis = Math.abs(camera.along(x, y)) < MAX_SAFE_COSINE * distance;
    return offTheAxis && !model.dependsOnBearing(zoom) ? Math.PI / 2 : camera.offAxis(x, y);
  }
}
