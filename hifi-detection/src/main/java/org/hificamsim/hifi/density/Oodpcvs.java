package org.hificamsim.hifi.density;

/** The levels of IEC 62676-4:2025, as a vendor reports them, in pixels per metre. */
enum Oodpcvs implements DemandedDensity {
  OVERVIEW(20),
  OUTLINE(40),
  DISCERN(80),
  PERCEIVE(125),
  CHARACTERISE(250),
  VALIDATE(500),
  SCRUTINISE(1500);

  private final double pixelsPerMetre;

  Oodpcvs(double pixelsPerMetre) {
    this.pixelsPerMetre = pixelsPerMetre;
  }

  @Override
  public double pixelsPerMetre() {
    return pixelsPerMetre;
  }
}
