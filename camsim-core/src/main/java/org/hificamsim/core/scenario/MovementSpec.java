package org.hificamsim.core.scenario;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * How a target moves.
 *
 * @param name the movement's name as the file gives it ({@code epics.movement.Straight}, {@code
 *     Waypoints}, a user's own); empty where the file gives none
 * @param mean mean of each coordinate's step, metres; Brownian only
 * @param std standard deviation of each coordinate's step, metres; Brownian only
 * @param waypoints the corners of the path; empty, or two and more
 * @param track what it follows; Tracks only
 */
public record MovementSpec(
    String name, double mean, double std, List<Waypoint> waypoints, Optional<Track> track) {
  /** What no file names: a target with a track comes by {@code tracks}. */
  static final String TRACKS = "Tracks";

  private static final String CAMSIM_PACKAGE = "epics.movement.";
  private static final Set<String> ON_PATH = Set.of("Waypoints", "Scripted");

  /** Copies what could change. */
  public MovementSpec {
    waypoints = List.copyOf(waypoints);
  }

  /** A movement without a track. */
  public MovementSpec(String name, double mean, double std, List<Waypoint> waypoints) {
    this(name, mean, std, waypoints, Optional.empty());
  }

  /** The movement along a track. */
  static MovementSpec along(Track track) {
    return new MovementSpec(TRACKS, 0, 1, List.of(), Optional.of(track));
  }

  /**
   * The movement's short name; without a name, Waypoints where there are waypoints, else Straight.
   */
  public String shortName() {
    if (name.isEmpty()) {
      return waypoints.isEmpty() ? "Straight" : "Waypoints";
    }
    return shortName(name);
  }

  /** A movement's name without CamSim's package. */
  static String shortName(String name) {
    return name.startsWith(CAMSIM_PACKAGE) ? name.substring(CAMSIM_PACKAGE.length()) : name;
  }

  /** Whether it follows waypoints, and has none. */
  public boolean lacksWaypoints() {
    return waypoints.isEmpty() && ON_PATH.contains(shortName());
  }

  /** Whether it follows a track, and has none. */
  public boolean lacksTrack() {
    return track.isEmpty() && shortName().equals(TRACKS);
  }

  /** The same parameters under another movement; none but Tracks keeps a track. */
  public MovementSpec withName(String newName) {
    boolean along = shortName(newName).equals(TRACKS);
    return new MovementSpec(newName, mean, std, waypoints, along ? track : Optional.empty());
  }
}
