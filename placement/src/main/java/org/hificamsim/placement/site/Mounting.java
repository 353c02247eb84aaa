package org.hificamsim.placement.site;

import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;

/**
 * The place where a camera is mounted, and the direction in which it looks.
 *
 * @param z the height in metres; empty in a flat world, and if the site gives the height of all
 *     cameras
 * @param tilt degrees below the horizon
 * @param heading the heading in degrees, from -180
 */
public record Mounting(Point position, Optional<Double> z, double tilt, double heading) {
  /** The height of new cameras on a site with heights that does not give one, in metres. */
  private static final double DEFAULT_HEIGHT = 3;

  /** Returns the height of new cameras on a site, in metres; empty in a flat world. */
  static OptionalDouble heightOn(Scenario site) {
    return site.hasHeights()
        ? OptionalDouble.of(site.mountHeight().orElse(DEFAULT_HEIGHT))
        : OptionalDouble.empty();
  }

  /** Returns the height of new cameras on a site that does not give one, in metres. */
  static Optional<Double> newHeightOn(Scenario site) {
    return site.mountHeight().isPresent()
        ? Optional.empty()
        : heightOn(site).stream().boxed().findFirst();
  }

  /** Returns the mounting, turned clockwise by an angle in degrees. */
  Mounting turnedBy(double degrees) {
    return new Mounting(position, z, tilt, sum(heading, degrees));
  }

  /** Returns the mounting with another tilt, in degrees. */
  Mounting tiltedTo(double newTilt) {
    return new Mounting(position, z, newTilt, heading);
  }

  /** Returns the mounting at another position. */
  Mounting movedTo(Point newPosition) {
    return new Mounting(newPosition, z, tilt, heading);
  }

  /** Returns the sum of two angles, in degrees from -180 to 180, rounded to millionths. */
  static double sum(double heading, double pan) {
    double angle = (heading + pan + 540) % 360 - 180;
    return Math.rint(angle * 1e6) / 1e6;
  }
}
