package org.hificamsim.tracks.format;

import org.hificamsim.core.Place;

/**
 * Where a target was at one time, in the units of its file.
 *
 * @param place in the file
 * @param target its name
 * @param tick when: seconds or frames, as the format counts
 * @param x to the east, or to the right of a picture, or the longitude
 * @param y to the north, or down a picture, or the latitude
 * @param width of the target, NaN where the file does not say
 * @param height of the target, NaN where the file does not say
 */
public record Sample(
    Place place, String target, double tick, double x, double y, double width, double height) {
  /** The same elsewhere, and of another size. */
  public Sample at(double newX, double newY, double newWidth, double newHeight) {
    return new Sample(place, target, tick, newX, newY, newWidth, newHeight);
  }

  /** A target whose size the file does not say. */
  public Sample(Place place, String target, double tick, double x, double y) {
    this(place, target, tick, x, y, Double.NaN, Double.NaN);
  }
}
