package org.hificamsim.tracks.place;

import org.hificamsim.core.scenario.Field;

/**
 * Where a drawing lies on the ground.
 *
 * @param scale metres that a pixel or unit of it is, above 0
 * @param x of its lower left corner, metres
 * @param y likewise
 */
public record PictureFrame(double scale, double x, double y) {
  /** The ground that a picture of this many pixels shows. */
  public Field area(double width, double height) {
    return new Field(x, x + width * scale, y, y + height * scale);
  }
}
