package org.hificamsim.profiling.check;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

/**
 * A target as it was seen: its box in the picture, and where it stood.
 *
 * @param left of the box, pixels
 * @param top of the box, pixels
 * @param width pixels, above 0
 * @param height pixels, above 0
 * @param foot its place on the ground, metres
 */
record Sighting(
    double frame,
    String target,
    double left,
    double top,
    double width,
    double height,
    Vector3D foot) {
  Size size() {
    return new Size(width, height);
  }

  /** Where the box stands. */
  Pixel stand() {
    return new Pixel(left + width / 2, top + height);
  }
}
