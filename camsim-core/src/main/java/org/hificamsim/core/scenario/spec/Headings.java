package org.hificamsim.core.scenario.spec;

/** What the numbers given as targets' headings mean. */
public enum Headings {
  /** Degrees, 0 is +y and 90 is +x. */
  DEGREES,
  /** The number is fed to sine and cosine as it is: what the coverage study's simulator did. */
  AS_RADIANS;

  /** The heading in radians. */
  public double radians(double heading) {
    return this == DEGREES ? Math.toRadians(heading) : heading;
  }
}
