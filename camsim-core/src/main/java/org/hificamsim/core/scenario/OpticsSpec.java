package org.hificamsim.core.scenario;

import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;

/**
 * The optics of a camera, as the scenario gives them: which views it can choose, and how long it
 * takes from one to another.
 *
 * @param name unique in the scenario
 * @param pixels width of the picture, 1 or more
 * @param anglesOfView horizontal, degrees, from the narrowest; empty for {@link OpticsLaw#ROUND}
 * @param reach metres: of the narrowest angle with {@link OpticsLaw#CONSTANT_AREA}, of every level
 *     with {@link OpticsLaw#PINHOLE}; none with {@link OpticsLaw#ROUND}, or where it is left to
 *     each camera
 * @param pans degrees off the mounted heading, rising, at least one
 * @param panSpeed degrees a second, above 0; none where a camera turns at once
 * @param zoomTime seconds from the first level to the last, 0 or more, evenly spread over the
 *     levels between
 */
public record OpticsSpec(
    String name,
    OpticsLaw law,
    OptionalInt pixels,
    List<Double> anglesOfView,
    OptionalDouble reach,
    List<Double> pans,
    OptionalDouble panSpeed,
    double zoomTime,
    Moving moving) {
  /** Copies what could change. */
  public OpticsSpec {
    anglesOfView = List.copyOf(anglesOfView);
    pans = List.copyOf(pans);
  }

  /** Whether the camera needs time for a move. */
  public boolean takesTime() {
    return panSpeed.isPresent() || zoomTime > 0;
  }
}
