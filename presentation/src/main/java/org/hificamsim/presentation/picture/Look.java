package org.hificamsim.presentation.picture;

import java.util.OptionalInt;

/**
 * How pictures show a run, where there is a choice.
 *
 * @param floor how opaque the floorplan is, in [0, 1]
 * @param zones the camera whose {@linkplain DensityZone pixel densities} are shown
 */
public record Look(double floor, OptionalInt zones) {
  /** Half through, without zones. */
  public static final Look USUAL = new Look(0.5, OptionalInt.empty());
}
