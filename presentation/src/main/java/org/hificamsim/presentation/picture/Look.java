package org.hificamsim.presentation.picture;

import java.util.OptionalInt;

/**
 * Settings of what pictures of a run show.
 *
 * @param floorOpacity the opacity of the floor plan, in [0, 1]
 * @param densityCamera the camera whose density zones are shown
 * @param tracks whether the tracks of targets over the whole run are shown
 */
public record Look(double floorOpacity, OptionalInt densityCamera, boolean tracks) {
  /** Settings for a half transparent floor plan, no density zones and no tracks. */
  public static final Look DEFAULT = new Look(0.5, OptionalInt.empty(), false);
}
