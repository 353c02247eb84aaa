package org.hificamsim.hifi.density;

/** The tasks of EN 62676-4:2014, Annex B, in pixels per metre. */
public enum Dori implements DemandedDensity {
  DETECT(25),
  OBSERVE(62.5),
  RECOGNISE(125),
  IDENTIFY(250);

  private final double pixelsPerMetre;

  Dori(double pixelsPerMetre) {
    this.pixelsPerMetre = pixelsPerMetre;
  }

  @Override
  public double pixelsPerMetre() {
    return pixelsPerMetre;
  }
}
