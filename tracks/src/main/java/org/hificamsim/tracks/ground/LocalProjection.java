package org.hificamsim.tracks.ground;

import static org.hificamsim.core.NamedSetting.setting;

import org.hificamsim.core.Place;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.tracks.format.TrackSample;

/**
 * The equirectangular projection about an origin on the ellipsoid WGS84. x is N cos(phi) times the
 * difference of longitudes and y is M times the difference of latitudes, where N and M are the
 * radii of curvature at the origin. At a distance of a kilometre, at 60 degrees latitude, the error
 * is less than half a metre.
 */
public final class LocalProjection implements Ground {
  private static final double EQUATORIAL_RADIUS = 6_378_137; // metres
  private static final double ECCENTRICITY_SQUARED = 6.694_379_990_14e-3;

  private double longitude = Double.NaN;
  private double latitude;
  private double metresPerLongitude;
  private double metresPerLatitude;

  /** Creates a projection whose origin is the first point that it converts. */
  public LocalProjection() {}

  /**
   * Creates a projection about a point.
   *
   * @param longitude the longitude in degrees
   * @param latitude the latitude in degrees
   */
  public LocalProjection(double longitude, double latitude) {
    setOrigin(longitude, latitude);
  }

  private void setOrigin(double originLongitude, double originLatitude) {
    longitude = originLongitude;
    latitude = originLatitude;
    double phi = Math.toRadians(latitude);
    double w = Math.sqrt(1 - ECCENTRICITY_SQUARED * Math.sin(phi) * Math.sin(phi));
    metresPerLongitude = Math.toRadians(EQUATORIAL_RADIUS / w * Math.cos(phi));
    metresPerLatitude =
        Math.toRadians(EQUATORIAL_RADIUS * (1 - ECCENTRICITY_SQUARED) / (w * w * w));
  }

  /** The longitude of the origin, in degrees; NaN if it has not been set. */
  public double longitude() {
    return longitude;
  }

  /** The latitude of the origin, in degrees. */
  public double latitude() {
    return latitude;
  }

  @Override
  public TrackSample onGround(TrackSample sample) {
    Point point = metres(sample.place(), sample.x(), sample.y());
    return sample.at(point.x(), point.y(), sample.width(), sample.height());
  }

  /** Converts a point in degrees to metres. */
  public Point metres(Place place, double pointLongitude, double pointLatitude) {
    if (!(Math.abs(pointLongitude) <= 180 && Math.abs(pointLatitude) <= 90)) {
      throw place.error(
          "longitude %s and latitude %s, expected -180 to 180 and -90 to 90 degrees, or %s (of"
              + " walls %s) if they are metres",
          pointLongitude, pointLatitude, setting("unit", "m"), setting("walls_unit", "m"));
    }
    if (Double.isNaN(longitude)) {
      setOrigin(pointLongitude, pointLatitude);
    }
    return new Point(
        (pointLongitude - longitude) * metresPerLongitude,
        (pointLatitude - latitude) * metresPerLatitude);
  }
}
