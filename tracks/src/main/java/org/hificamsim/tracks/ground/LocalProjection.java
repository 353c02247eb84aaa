package org.hificamsim.tracks.ground;

import org.hificamsim.core.Place;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.tracks.format.TrackSample;

/**
 * The equirectangular projection about an origin, on the ellipsoid WGS84: x is N cos(phi) times the
 * difference of longitudes, y is M times that of latitudes, N and M the radii of curvature at the
 * origin. A kilometre from there, at 60 degrees, it is off by less than half a metre in a thousand.
 */
public final class LocalProjection implements Ground {
  private static final double EQUATOR = 6_378_137; // m
  private static final double ECCENTRICITY_2 = 6.694_379_990_14e-3;

  private double longitude = Double.NaN;
  private double latitude;
  private double metresX;
  private double metresY;

  /** A projection whose origin is the first point that it is asked for. */
  public LocalProjection() {}

  /**
   * A projection about a point.
   *
   * @param longitude degrees
   * @param latitude degrees
   */
  public LocalProjection(double longitude, double latitude) {
    begin(longitude, latitude);
  }

  private void begin(double itsLongitude, double itsLatitude) {
    longitude = itsLongitude;
    latitude = itsLatitude;
    double phi = Math.toRadians(latitude);
    double w = Math.sqrt(1 - ECCENTRICITY_2 * Math.sin(phi) * Math.sin(phi));
    metresX = Math.toRadians(EQUATOR / w * Math.cos(phi));
    metresY = Math.toRadians(EQUATOR * (1 - ECCENTRICITY_2) / (w * w * w));
  }

  /** The origin's longitude, degrees; NaN before there is one. */
  public double longitude() {
    return longitude;
  }

  /** The origin's latitude, degrees. */
  public double latitude() {
    return latitude;
  }

  @Override
  public TrackSample onGround(TrackSample sample) {
    Point point = metres(sample.place(), sample.x(), sample.y());
    return sample.at(point.x(), point.y(), sample.width(), sample.height());
  }

  /** A point of the ellipsoid, degrees, as one of the plane. */
  public Point metres(Place place, double itsLongitude, double itsLatitude) {
    if (!(Math.abs(itsLongitude) <= 180 && Math.abs(itsLatitude) <= 90)) {
      throw place.error(
          "longitude %s and latitude %s, expected -180 to 180 and -90 to 90 degrees",
          itsLongitude, itsLatitude);
    }
    if (Double.isNaN(longitude)) {
      begin(itsLongitude, itsLatitude);
    }
    return new Point((itsLongitude - longitude) * metresX, (itsLatitude - latitude) * metresY);
  }
}
