package org.hificamsim.profiling.check;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.hificamsim.tracks.format.MotFile;

/**
 * A target as it was seen: its box in the picture, and where it stood.
 *
 * @param foot its place on the ground, metres
 */
record Sighting(MotFile.Row box, Vector3D foot) {
  Size size() {
    return new Size(box.width(), box.height());
  }

  /** Where the box stands. */
  Calibration.Pixel stand() {
    return new Calibration.Pixel(box.footX(), box.footY());
  }
}
