package org.hificamsim.tracks.format;

import org.hificamsim.core.Place;

/**
 * The position of a target at one time, in the units of its file.
 *
 * @param place the sample's place in the file
 * @param target the target's name
 * @param tick the time in seconds or frames, according to the format
 * @param x the position to the east, to the right in a picture, or the longitude
 * @param y the position to the north, down in a picture, or the latitude
 * @param width width of the target, NaN if the file has none
 * @param height height of the target, NaN if the file has none
 */
public record TrackSample(
    Place place, String target, double tick, double x, double y, double width, double height) {
  private static final double MAX_COORDINATE = 1e9;

  /** Whether time and position are numbers, and the position is not too large. */
  boolean isValid() {
    return Double.isFinite(tick) && Math.abs(x) <= MAX_COORDINATE && Math.abs(y) <= MAX_COORDINATE;
  }

  /** Returns this sample with another position and size. */
  public TrackSample at(double newX, double newY, double newWidth, double newHeight) {
    return new TrackSample(place, target, tick, newX, newY, newWidth, newHeight);
  }

  /** Creates a sample without a size. */
  public TrackSample(Place place, String target, double tick, double x, double y) {
    this(place, target, tick, x, y, Double.NaN, Double.NaN);
  }
}
