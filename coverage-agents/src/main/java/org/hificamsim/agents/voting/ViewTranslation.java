package org.hificamsim.agents.voting;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.hificamsim.agents.temporal.ActionValues;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.policy.NetworkView;

/**
 * Translates a view of one camera to the nearest view of another one: the nearest pan angle
 * relative to the heading, and the nearest zoom level. Levels of two lenses are compared by the
 * ratio of their angles of view; levels without a lens, by their relative position between the
 * narrowest and the widest. If several are equally near, the first pan angle and the widest level
 * are taken. Between cameras with equal views, views stay the same.
 *
 * <p>The translation is for the views that cameras have at the beginning. Cameras of one kind share
 * a table.
 */
final class ViewTranslation {
  /**
   * Cameras with views that a translation does not distinguish.
   *
   * @param pans radians relative to the heading
   * @param lens whether {@code levels} are logarithms of angles of view, and not positions in [0,
   *     1]
   */
  private record Kind(List<Double> pans, boolean lens, List<Double> levels) {
    static Kind of(NetworkView network, int camera) {
      int zooms = network.zooms(camera);
      boolean lens =
          IntStream.range(0, zooms).allMatch(zoom -> network.zoom(camera, zoom).hasLens());
      return new Kind(
          IntStream.range(0, network.pans(camera))
              .mapToObj(pan -> network.pan(camera, network.viewAt(camera, pan, 0)))
              .toList(),
          lens,
          IntStream.range(0, zooms)
              .mapToObj(zoom -> lens ? size(network.zoom(camera, zoom)) : position(zoom, zooms))
              .toList());
    }

    private static double size(ZoomLevel zoom) {
      return StrictMath.log(zoom.angleOfView());
    }

    private static double position(int zoom, int zooms) {
      return zooms == 1 ? 1 : zoom / (zooms - 1.0);
    }

    /** Returns for each view the nearest view of another kind. */
    int[] translation(Kind target) {
      int zooms = levels.size();
      return IntStream.range(0, pans.size() * zooms)
          .map(
              view ->
                  target.nearestPan(pans.get(view / zooms)) * target.levels.size()
                      + nearestLevel(target, view % zooms))
          .toArray();
    }

    private int nearestPan(double angle) {
      int nearest = 0;
      for (int pan = 1; pan < pans.size(); pan++) {
        nearest = difference(pan, angle) < difference(nearest, angle) ? pan : nearest;
      }
      return nearest;
    }

    private double difference(int pan, double angle) {
      return Math.abs(Math.IEEEremainder(pans.get(pan) - angle, 2 * Math.PI));
    }

    private int nearestLevel(Kind target, int zoom) {
      boolean byAngle = lens && target.lens;
      List<Double> targetLevels = byAngle ? target.levels : target.positions();
      double level = byAngle ? levels.get(zoom) : position(zoom, levels.size());
      int nearest = 0;
      for (int i = 1; i < targetLevels.size(); i++) {
        double difference = Math.abs(targetLevels.get(i) - level);
        nearest = difference <= Math.abs(targetLevels.get(nearest) - level) ? i : nearest;
      }
      return nearest;
    }

    private List<Double> positions() {
      int zooms = levels.size();
      return IntStream.range(0, zooms).mapToObj(zoom -> position(zoom, zooms)).toList();
    }
  }

  private final ActionValues q;
  private final int[] kinds;
  private final boolean oneKind;

  /** The nearest view of the other kind, by kind, other kind and view. */
  private final int[][][] tables;

  /**
   * @param q action values from which neighbours answer
   */
  ViewTranslation(NetworkView network, ActionValues q) {
    this.q = q;
    Map<Kind, Integer> kindNumbers = new LinkedHashMap<>();
    kinds = new int[network.cameras()];
    for (int camera = 0; camera < kinds.length; camera++) {
      Kind cameraKind = Kind.of(network, camera);
      kinds[camera] = kindNumbers.computeIfAbsent(cameraKind, kind -> kindNumbers.size());
    }
    List<Kind> allKinds = new ArrayList<>(kindNumbers.keySet());
    oneKind = allKinds.size() == 1;
    tables = new int[allKinds.size()][allKinds.size()][];
    for (int from = 0; from < tables.length; from++) {
      for (int to = 0; to < tables.length; to++) {
        tables[from][to] = allKinds.get(from).translation(allKinds.get(to));
      }
    }
  }

  /**
   * Returns the answer of a neighbour to a query: its own best view in the nearest of its states,
   * translated to a view of the camera that asks.
   *
   * @param state state of the asking camera, which follows from its view and percept
   */
  int answer(int camera, int neighbour, int state, int view, int percept) {
    if (oneKind || kinds[camera] == kinds[neighbour]) {
      return q.best(neighbour, state);
    }
    int neighbourState = q.state(neighbour, view(camera, neighbour, view), percept);
    return view(neighbour, camera, q.best(neighbour, neighbourState));
  }

  /** Returns the other camera's view that is nearest to a view of a camera. */
  int view(int camera, int other, int view) {
    return tables[kinds[camera]][kinds[other]][view];
  }
}
