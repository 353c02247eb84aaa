package org.hificamsim.core.scenario;

import java.util.Map;
import java.util.Optional;

/**
 * A target as the scenario gives it.
 *
 * @param origin the element that brings it
 * @param features its identity, unique among the targets present
 * @param x start position, metres; may lie outside the field
 * @param heading in the unit of {@link Scenario#headings}
 * @param speed metres per step
 * @param size edge of its bounding box q, metres, above 0
 * @param extent width and height, where the file gives them; the size follows from them
 * @param extras attributes that nothing here reads, kept for the writer
 */
public record TargetSpec(
    Origin origin,
    double features,
    double x,
    double y,
    double heading,
    double speed,
    double size,
    Optional<Extent> extent,
    MovementSpec movement,
    Map<String, String> extras) {
  /** The largest object of the thesis's lab (Table 4.1). */
  public static final double DEFAULT_SIZE = 0.66;

  /** The elements that bring a target. */
  public enum Origin {
    /** {@code object}. */
    OBJECT,
    /** {@code object_with_waypoints}. */
    OBJECT_WITH_WAYPOINTS,
    /** An event that adds an object. */
    EVENT,
    /** {@code tracks}. */
    TRACK
  }

  /** Copies what could change. */
  public TargetSpec {
    extras = Map.copyOf(extras);
  }

  /** A target that has a size alone. */
  public TargetSpec(
      Origin origin,
      double features,
      double x,
      double y,
      double heading,
      double speed,
      double size,
      MovementSpec movement,
      Map<String, String> extras) {
    this(origin, features, x, y, heading, speed, size, Optional.empty(), movement, extras);
  }

  /** How wide it is, seen from above, metres. */
  public double width() {
    return extent.map(Extent::width).orElse(size);
  }

  /** The name in result files: the features value, as CamSim prints it. */
  public String name() {
    return Double.toString(features);
  }

  /** The same target at another speed. */
  public TargetSpec withSpeed(double newSpeed) {
    return new TargetSpec(
        origin, features, x, y, heading, newSpeed, size, extent, movement, extras);
  }

  /** The same target under another movement. */
  public TargetSpec withMovement(String name) {
    return new TargetSpec(
        origin, features, x, y, heading, speed, size, extent, movement.withName(name), extras);
  }

  /** The same target with another size, metres. */
  public TargetSpec withSize(double newSize) {
    return new TargetSpec(origin, features, x, y, heading, speed, newSize, movement, extras);
  }
}
