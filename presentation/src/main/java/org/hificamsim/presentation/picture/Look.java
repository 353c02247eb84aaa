package org.hificamsim.presentation.picture;

import java.util.OptionalInt;

/**
 * How pictures show a run, where there is a choice.
 *
 * @param floor how opaque the floorplan is, in [0, 1]
 * @param zones the camera whose pixel densities are shown
 * @param tracks whether it is shown where each target went over the whole run
 */
public record Look(double floor, OptionalInt zones, boolean tracks) {
  /** Half through, without zones or tracks. */
  public static final Look USUAL = new Look(0.5, OptionalInt.empty(), false);
}
