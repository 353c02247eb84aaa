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
 * @param pans radians off the mounted heading, rising, at least one
 * @param tilts radians below the horizon, rising, at least one
 * @param zooms from the narrowest, at least one
 * @param panSpeed radians a second, also of tilting; infinite where the camera turns at once
 * @param zoomSpeed levels a second; infinite where the lens changes at once
 */
public record ViewSet(
    List<Double> pans,
    List<Double> tilts,
    List<ZoomLevel> zooms,
    double panSpeed,
    double zoomSpeed,
    Moving moving) {
  private static final double AT_ONCE = Double.POSITIVE_INFINITY;

  /** The views of a camera that cannot turn. */
  public static ViewSet of(List<ZoomLevel> zooms) {
    return new ViewSet(List.of(0.0), List.of(0.0), zooms, AT_ONCE, AT_ONCE, Moving.BLIND);
  }

  /** The views that optics make of these zoom levels. */
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

  /** The same in a flat world. */
  public static ViewSet ofLens(OpticsSpec optics, double ownReach, double mountHeight) {
    return ofLens(optics, ownReach, mountHeight, VerticalView.FLAT);
  }

  /**
   * The views of a camera with a lens, which has a zoom level for each of its angles of view.
   *
   * @param optics of a law that has angles of view
   * @param ownReach the camera's reach where its optics say none, metres
   * @param mountHeight metres; NaN where it is not known
   * @param mounted how high the camera is and how far it looks down, whatever its levels
   */
  static ViewSet ofLens(
      OpticsSpec optics, double ownReach, double mountHeight, VerticalView mounted) {
    double reach = optics.reach().orElse(ownReach);
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

  /** Copies what could change. */
  public ViewSet {
    pans = List.copyOf(pans);
    tilts = List.copyOf(tilts);
    zooms = List.copyOf(zooms);
  }

  /** How many there are. */
  public int count() {
    return pans.size() * tilts.size() * zooms.size();
  }

  /** The pan angle of a view, by its number. */
  public int panOf(int view) {
    return view / zooms.size() / tilts.size();
  }

  /** The tilt of a view, by its number. */
  public int tiltOf(int view) {
    return view / zooms.size() % tilts.size();
  }

  /** The zoom level of a view, by its number. */
  public int zoomOf(int view) {
    return view % zooms.size();
  }

  /** Radians off the mounted heading. */
  public double pan(int view) {
    return pans.get(panOf(view));
  }

  /** Radians below the horizon. */
  public double tilt(int view) {
    return tilts.get(tiltOf(view));
  }

  /** The zoom level of a view, as it is at the tilt. */
  public ZoomLevel zoom(int view) {
    ZoomLevel level = zooms.get(zoomOf(view));
    VerticalView vertical = level.vertical();
    return tilt(view) == vertical.tilt()
        ? level
        : level.with(new VerticalView(vertical.z(), tilt(view), vertical.angle()));
  }

  /** Where a camera starts: its widest zoom at the angles nearest to its heading and own tilt. */
  public int home() {
    return nearest(0, zooms.get(0).vertical().tilt(), zooms.size() - 1);
  }

  /** Whether a view is at most one zoom level and one pan angle away from another. */
  public boolean isNextTo(int view, int other) {
    if (pans.size() == 1 && tilts.size() == 1) {
      return Math.abs(view - other) <= 1; // without divisions
    }
    return Math.abs(zoomOf(view) - zoomOf(other)) <= 1
        && Math.abs(panOf(view) - panOf(other)) <= 1
        && Math.abs(tiltOf(view) - tiltOf(other)) <= 1;
  }

  boolean takesTime() {
    return panSpeed < Double.POSITIVE_INFINITY || zoomSpeed < Double.POSITIVE_INFINITY;
  }

  /** The view that a camera passes; of two equally near ones the one farther left or narrower. */
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
