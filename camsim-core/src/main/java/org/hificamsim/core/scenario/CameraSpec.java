package org.hificamsim.core.scenario;

import java.util.Map;
import java.util.Optional;

/**
 * A camera as the scenario gives it.
 *
 * @param name unique in the scenario
 * @param x position, metres, inside the field
 * @param heading degrees, 0 is +y and 90 is +x
 * @param viewingAngle full opening angle, degrees, (0, 360]
 * @param range radius of the field of view, metres, 0 or more; not used where the scenario has a
 *     zoom list
 * @param optics what views it can choose; without, those of its angle and range
 * @param extras attributes that nothing here reads, kept for the writer
 */
public record CameraSpec(
    String name,
    double x,
    double y,
    double heading,
    double viewingAngle,
    double range,
    AgentSpec agent,
    Optional<OpticsSpec> optics,
    Map<String, String> extras) {
  /** Copies what could change. */
  public CameraSpec {
    extras = Map.copyOf(extras);
  }

  /** A camera without optics. */
  public CameraSpec(
      String name,
      double x,
      double y,
      double heading,
      double viewingAngle,
      double range,
      AgentSpec agent,
      Map<String, String> extras) {
    this(name, x, y, heading, viewingAngle, range, agent, Optional.empty(), extras);
  }

  /** The same camera elsewhere; metres and degrees. */
  public CameraSpec standing(double newX, double newY, double newHeading) {
    return new CameraSpec(name, newX, newY, newHeading, viewingAngle, range, agent, optics, extras);
  }

  /** The same camera with other optics and another opening angle, degrees. */
  public CameraSpec through(OpticsSpec newOptics, double angle) {
    return new CameraSpec(name, x, y, heading, angle, range, agent, Optional.of(newOptics), extras);
  }

  /** The same camera under another name. */
  public CameraSpec named(String newName) {
    return new CameraSpec(newName, x, y, heading, viewingAngle, range, agent, optics, extras);
  }
}
