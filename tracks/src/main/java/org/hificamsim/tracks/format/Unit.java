package org.hificamsim.tracks.format;

/** The units of positions. */
public enum Unit {
  /** Metres. */
  M(1),
  /** Centimetres. */
  CM(0.01),
  /** Millimetres. */
  MM(0.001),
  /** Pixels of a picture, where y points down; a homography converts them to metres. */
  PX(Double.NaN),
  /** Degrees of longitude and latitude (WGS84). */
  DEG(Double.NaN);

  private final double metres;

  Unit(double metres) {
    this.metres = metres;
  }

  /** The unit in metres; NaN if that depends on the position. */
  public double metres() {
    return metres;
  }
}
