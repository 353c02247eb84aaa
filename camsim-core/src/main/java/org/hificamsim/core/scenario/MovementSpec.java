package org.hificamsim.core.scenario;

import java.util.List;

/**
 * How a target moves.
 *
 * @param name the movement's name as the file gives it ({@code epics.movement.Straight}, {@code
 *     Waypoints}, a user's own); empty where the file gives none
 * @param mean mean of each coordinate's step, metres; Brownian only
 * @param std standard deviation of each coordinate's step, metres; Brownian only
 * @param waypoints the corners of the path; empty, or two and more
 */
public record MovementSpec(String name, double mean, double std, List<Waypoint> waypoints) {
  private static final String CAMSIM_PACKAGE = "epics.movement.";

  /** Copies what could change. */
  public MovementSpec {
    waypoints = List.copyOf(waypoints);
  }

  /**
   * The movement's short name; without a name, Waypoints where there are waypoints, else Straight.
   */
  public String shortName() {
    if (name.isEmpty()) {
      return waypoints.isEmpty() ? "Straight" : "Waypoints";
    }
    return name.startsWith(CAMSIM_PACKAGE) ? name.substring(CAMSIM_PACKAGE.length()) : name;
  }

  /** The same parameters under another movement. */
  public MovementSpec withName(String newName) {
    return new MovementSpec(newName, mean, std, waypoints);
  }
}
