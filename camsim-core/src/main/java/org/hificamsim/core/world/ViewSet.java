package org.hificamsim.core.world;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.hificamsim.core.detection.VerticalView;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.spec.Moving;
import org.hificamsim.core.scenario.spec.OpticsLaw;
import org.hificamsim.core.scenario.spec.OpticsSpec;

/**
 * The views of a kind of camera: each of its zoom levels at each of its tilts at each of its pan
 * angles. View {@code (pan * tilts + tilt) * zooms + zoom} has that pan, tilt and zoom.
 *
 * @param pans the pan angles, radians off the mounted heading, rising, at least one
 * @param tilts the tilt angles, radians below the horizon, rising, at least one
 * @param zooms the zoom levels from the narrowest, at least one
 * @param panSpeed the pan speed, radians a second, also of tilting; infinite if the camera turns at
 *     once
 * @param zoomSpeed levels a second; infinite if the lens changes at once
 */
public record ViewSet(
    List<Double> pans,
    List<Double> tilts,
    List<ZoomLevel> zooms,
    double panSpeed,
    double zoomSpeed,
    Moving moving) {
  private static final double AT_ONCE = Double.POSITIVE_INFINITY;

  /** Makes the views of a camera that cannot turn. */
  public static ViewSet of(List<ZoomLevel> zooms) {
    return new ViewSet(List.of(0.0), List.of(0.0), zooms, AT_ONCE, AT_ONCE, Moving.BLIND);
  }

  /** Makes the views of a camera with these optics and zoom levels. */
  static ViewSet of(OpticsSpec optics, List<ZoomLevel> zooms) {
    double tilt = zooms.get(0).vertical().tilt();
    return new ViewSet(
        optics.pans().stream().map(Math::toRadians).toList(),
        optics.tilts().stream().map(off -> tilt + Math.toRadians(off)).toList(),
        zooms,
        Math.toRadians(optics.panSpeed().orElse(AT_ONCE)),
        optics.zoomTime() == 0 ? AT_ONCE : (zooms.size() - 1) / optics.zoomTime(),
        optics.moving());
  }

  /** Makes the views of a camera with a lens in a flat world. */
  public static ViewSet ofLens(OpticsSpec optics, double defaultReach, double mountHeight) {
    return ofLens(optics, defaultReach, mountHeight, VerticalView.FLAT);
  }

  /**
   * Makes the views of a camera with a lens: one zoom level for each of its angles of view.
   *
   * @param optics the optics with a law that has angles of view
   * @param defaultReach the default reach, in metres; the reach if the optics have none
   * @param mountHeight the mount height, in metres; NaN if unknown
   * @param mounted height and tilt of the camera
   */
  static ViewSet ofLens(
      OpticsSpec optics, double defaultReach, double mountHeight, VerticalView mounted) {
    double reach = optics.reach().orElse(defaultReach);
    List<Double> angles = optics.anglesOfView();
    List<Double> radii = optics.law().radii(angles, reach);
    double least = Collections.min(radii);
    double most = Collections.max(radii);
    int pixels = optics.pixels().orElse(0);
    List<ZoomLevel> zooms = new ArrayList<>();
    for (int i = 0; i < radii.size(); i++) {
      double angle = Math.toRadians(angles.get(i));
      double upright =
          mounted.flat() || optics.law() != OpticsLaw.PINHOLE
              ? Double.NaN
              : Math.toRadians(optics.verticalAngles().get(i));
      VerticalView vertical = new VerticalView(mounted.z(), mounted.tilt(), upright);
      zooms.add(
          new ZoomLevel(radii.get(i), least, most, mountHeight, angle, angle, pixels, vertical));
    }
    return of(optics, zooms);
  }

  /** Copies the lists. */
  public ViewSet {
    pans = List.copyOf(pans);
    tilts = List.copyOf(tilts);
    zooms = List.copyOf(zooms);
  }

  /** The number of views. */
  public int count() {
    return pans.size() * tilts.size() * zooms.size();
  }

  /** The pan angle of a view, by its number. */
  public int panOf(int view) {
    return hasOneDirection() ? 0 : view / zooms.size() / tilts.size();
  }

  /** The tilt of a view, by its number. */
  public int tiltOf(int view) {
    return view / zooms.size() % tilts.size();
  }

  /** The zoom level of a view, by its number. */
  public int zoomOf(int view) {
    return hasOneDirection() ? view : view % zooms.size();
  }

  /** Whether a view is a zoom level and nothing else: most are, and need no divisions. */
  private boolean hasOneDirection() {
    return pans.size() == 1 && tilts.size() == 1;
  }

  /** The pan angle of a view, radians off the mounted heading. */
  public double pan(int view) {
    return pans.get(panOf(view));
  }

  /** The tilt of a view, radians below the horizon. */
  public double tilt(int view) {
    return tilts.get(tiltOf(view));
  }

  /** The zoom level of a view, with the view's tilt. */
  public ZoomLevel zoom(int view) {
    ZoomLevel level = zooms.get(zoomOf(view));
    VerticalView vertical = level.vertical();
    return tilt(view) == vertical.tilt()
        ? level
        : level.with(new VerticalView(vertical.z(), tilt(view), vertical.angle()));
  }

  /** The view at the start: the widest zoom, nearest to the camera's heading and own tilt. */
  public int home() {
    return nearest(0, zooms.get(0).vertical().tilt(), zooms.size() - 1);
  }

  /** Whether a view is at most one zoom level and one pan angle away from another. */
  public boolean isNextTo(int view, int other) {
    if (hasOneDirection()) {
      return Math.abs(view - other) <= 1;
    }
    return Math.abs(zoomOf(view) - zoomOf(other)) <= 1
        && Math.abs(panOf(view) - panOf(other)) <= 1
        && Math.abs(tiltOf(view) - tiltOf(other)) <= 1;
  }

  boolean takesTime() {
    return panSpeed < Double.POSITIVE_INFINITY || zoomSpeed < Double.POSITIVE_INFINITY;
  }

  /** The view nearest to these values; of two equally near ones the left or narrower one. */
  int nearest(double pan, double tilt, double zoom) {
    int direction = nearest(pans, pan) * tilts.size() + nearest(tilts, tilt);
    return direction * zooms.size() + (int) Math.ceil(zoom - 0.5);
  }

  private static int nearest(List<Double> angles, double angle) {
    int nearest = 0;
    for (int i = 1; i < angles.size(); i++) {
      if (Math.abs(angles.get(i) - angle) < Math.abs(angles.get(nearest) - angle)) {
        nearest = i;
      }
    }
    return nearest;
  }
}
