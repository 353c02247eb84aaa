package org.hificamsim.hifi.density;

/** A task of a standard. */
interface DemandedDensity {
  /** What it demands. */
  double pixelsPerMetre();
}
