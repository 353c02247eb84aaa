package org.hificamsim.tracks.format;

import org.hificamsim.core.Place;

/**
 * A row of a MOTChallenge file: a target's box in one frame.
 *
 * @param place in the file
 * @param frame from 1
 * @param target its number
 * @param left of the box, pixels
 * @param top of the box, pixels from the picture's upper edge down
 * @param width pixels
 * @param height pixels
 * @param confidence 0 where the row is not to count; 1 where the file has none
 * @param x in the world, NaN where the file does not say
 * @param y in the world, NaN where the file does not say
 * @param z in the world, NaN where the file does not say
 */
public record MotRow(
    Place place,
    double frame,
    String target,
    double left,
    double top,
    double width,
    double height,
    double confidence,
    double x,
    double y,
    double z) {
  /** Whether the file says where on the ground the target was. */
  public boolean inWorld() {
    return !Double.isNaN(x);
  }

  /** Where the box stands, to the right, pixels. */
  public double footX() {
    return left + width / 2;
  }

  /** Where the box stands, down, pixels. */
  public double footY() {
    return top + height;
  }
}
