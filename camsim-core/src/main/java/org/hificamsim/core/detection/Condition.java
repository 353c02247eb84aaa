package org.hificamsim.core.detection;

import java.util.Locale;

/** What else than a target's size on the picture a confidence may depend on. */
public enum Condition {
  /** The lens's f-number N. */
  APERTURE(0, 1000, "an f-number from 0 to 1000"),
  /** k of the lens: a point at radius r (1 in the corners) shows what belongs at r (1 + k r^2). */
  DISTORTION(-1, 1, "k of radial distortion, from -1 to 1"),
  /** How bright the scene is, in the unit of the photos that a model was fitted to. */
  LIGHT(Double.MIN_NORMAL, 1e9, "a brightness above 0 and at most 1e9");

  private final double least;
  private final double most;
  private final String expected;

  Condition(double least, double most, String expected) {
    this.least = least;
    this.most = most;
    this.expected = expected;
  }

  /** Its name in scenarios, data sets and model files. */
  public String key() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The least value it can have. */
  public double least() {
    return least;
  }

  /** The greatest value it can have. */
  public double most() {
    return most;
  }

  /** What it can be, as error lines say it. */
  public String expected() {
    return expected;
  }
}
