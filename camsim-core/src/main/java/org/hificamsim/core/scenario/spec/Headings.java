package org.hificamsim.core.scenario.spec;

/** The unit of the headings of targets. */
public enum Headings {
  /** Degrees, 0 is +y and 90 is +x. */
  DEGREES,
  /** Radians: sine and cosine take the number itself, as the coverage study's simulator did. */
  AS_RADIANS;

  /** The heading in radians. */
  public double radians(double heading) {
    return this == DEGREES ? Math.toRadians(heading) : heading;
  }
}
