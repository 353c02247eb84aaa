package org.hificamsim.core.world;

import java.util.List;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.Moving;

/**
 * The views of a kind of camera: each of its zoom levels at each of its pan angles. View {@code pan
 * * zooms + zoom} has that pan and that zoom.
 *
 * @param pans radians off the mounted heading, rising, at least one
 * @param zooms from the narrowest, at least one
 * @param panSpeed radians a second; infinite where the camera turns at once
 * @param zoomSpeed levels a second; infinite where the lens changes at once
 */
record ViewSet(
    List<Double> pans, List<ZoomLevel> zooms, double panSpeed, double zoomSpeed, Moving moving) {
  /** The views of a camera that cannot turn. */
  static ViewSet of(List<ZoomLevel> zooms) {
    double atOnce = Double.POSITIVE_INFINITY;
    return new ViewSet(List.of(0.0), zooms, atOnce, atOnce, Moving.BLIND);
  }

  /** Copies what could change. */
  ViewSet {
    pans = List.copyOf(pans);
    zooms = List.copyOf(zooms);
  }

  int count() {
    return pans.size() * zooms.size();
  }

  int panOf(int view) {
    return view / zooms.size();
  }

  int zoomOf(int view) {
    return view % zooms.size();
  }

  double pan(int view) {
    return pans.get(panOf(view));
  }

  ZoomLevel zoom(int view) {
    return zooms.get(zoomOf(view));
  }

  /** Where a camera starts: its widest zoom at the pan angle that is nearest to its heading. */
  int home() {
    return nearestPan(0) * zooms.size() + zooms.size() - 1;
  }

  boolean takesTime() {
    return panSpeed < Double.POSITIVE_INFINITY || zoomSpeed < Double.POSITIVE_INFINITY;
  }

  /** The view that a camera passes; of two equally near ones the one farther left or narrower. */
  int nearest(double pan, double zoom) {
    return nearestPan(pan) * zooms.size() + (int) Math.ceil(zoom - 0.5);
  }

  private int nearestPan(double pan) {
    int nearest = 0;
    for (int i = 1; i < pans.size(); i++) {
      if (Math.abs(pans.get(i) - pan) < Math.abs(pans.get(nearest) - pan)) {
        nearest = i;
      }
    }
    return nearest;
  }
}
