package org.hificamsim.tracks.format;

/** What positions are measured in. */
public enum Unit {
  /** Metres. */
  M(1),
  /** Centimetres. */
  CM(0.01),
  /** Millimetres. */
  MM(0.001),
  /** Pixels of a picture, y down; a homography takes them to the ground. */
  PX(Double.NaN),
  /** Degrees of longitude and latitude (WGS84). */
  DEG(Double.NaN);

  private final double metres;

  Unit(double metres) {
    this.metres = metres;
  }

  /** How many metres it is; NaN where that depends on the place. */
  public double metres() {
    return metres;
  }
}
