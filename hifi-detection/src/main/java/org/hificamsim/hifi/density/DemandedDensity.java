package org.hificamsim.hifi.density;

/** A task of a standard. */
public interface DemandedDensity {
  /** What it demands. */
  double pixelsPerMetre();
}
