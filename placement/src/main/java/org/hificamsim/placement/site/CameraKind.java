package org.hificamsim.placement.site;

import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsSpec;

/**
 * A kind of camera that can be bought.
 *
 * @param optics the lens, which may pan and zoom
 * @param price the price in the currency of the catalogue, above 0
 */
public record CameraKind(String name, OpticsSpec optics, double price) {
  /**
   * Returns the kinds of a site's cameras, each at the price of 1.
   *
   * @param site the name of the site
   * @throws InputException if no camera has a lens
   */
  static List<CameraKind> of(String site, Stream<CameraSpec> cameras) {
    List<CameraKind> kinds =
        cameras
            .flatMap(camera -> camera.optics().stream())
            .filter(optics -> optics.law().hasAngles())
            .distinct()
            .map(optics -> new CameraKind(optics.name(), optics, 1))
            .toList();
    if (kinds.isEmpty()) {
      throw InputException.of(
          "scenario '%s' has no camera with a lens, expected one, or generic ones or a file", site);
    }
    return kinds;
  }

  /**
   * Returns the lens, set to an angle of view. A lens that turns stays as it is unless an angle is
   * given.
   *
   * @param angle the angle in degrees; null for the widest, or for a lens that turns as it is
   * @throws InputException if the lens has no such angle
   */
  OpticsSpec setTo(Double angle) {
    double narrowest = Collections.min(optics.anglesOfView());
    double widest = Collections.max(optics.anglesOfView());
    if (optics.pans().size() > 1 && angle == null) {
      return optics;
    }
    double newAngle = angle == null ? widest : angle;
    if (!(newAngle >= narrowest && newAngle <= widest)) {
      throw InputException.of(
          "angle is %s, expected degrees from %s to %s for '%s'",
          newAngle, narrowest, widest, name);
    }
    OpticsSpec lens = optics.with(OpticsSpec.ANGLES_OF_VIEW, List.of(newAngle));
    return Candidates.atLevel(lens, 0);
  }
}
