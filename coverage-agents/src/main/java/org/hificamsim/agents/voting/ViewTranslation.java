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
 * Which of a camera's views comes nearest to one of another camera's: the nearest pan angle off the
 * heading, and the nearest zoom level. Levels of two lenses are as near as the ratio of their
 * angles of view; without a lens, as their places between the narrowest level and the widest. Of
 * equally near ones the first pan angle and the widest level count. Cameras with equal views have
 * the same.
 *
 * <p>It holds for the views that cameras begin with. Cameras of a kind share a table.
 */
final class ViewTranslation {
  /**
   * Cameras whose views are alike, as far as a translation goes.
   *
   * @param pans radians off the heading
   * @param lens whether {@code levels} are logarithms of angles of view, and not places in [0, 1]
   */
  private record Kind(List<Double> pans, boolean lens, List<Double> levels) {
    static Kind of(NetworkView network, int camera) {
      int zooms = network.zooms(camera);
      boolean lens = IntStream.range(0, zooms).allMatch(i -> network.zoom(camera, i).hasLens());
      return new Kind(
          IntStream.range(0, network.pans(camera))
              .mapToObj(pan -> network.pan(camera, network.viewAt(camera, pan, 0)))
              .toList(),
          lens,
          IntStream.range(0, zooms)
              .mapToObj(i -> lens ? size(network.zoom(camera, i)) : place(i, zooms))
              .toList());
    }

    private static double size(ZoomLevel zoom) {
      return StrictMath.log(zoom.angleOfView());
    }

    private static double place(int zoom, int zooms) {
      return zooms == 1 ? 1 : zoom / (zooms - 1.0);
    }

    int[] translated(Kind to) {
      int zooms = levels.size();
      return IntStream.range(0, pans.size() * zooms)
          .map(view -> to.pan(pans.get(view / zooms)) * to.levels.size() + level(to, view % zooms))
          .toArray();
    }

    private int pan(double angle) {
      int nearest = 0;
      for (int pan = 1; pan < pans.size(); pan++) {
        nearest = turn(pan, angle) < turn(nearest, angle) ? pan : nearest;
      }
      return nearest;
    }

    private double turn(int pan, double angle) {
      return Math.abs(Math.IEEEremainder(pans.get(pan) - angle, 2 * Math.PI));
    }

    private int level(Kind to, int zoom) {
      List<Double> among = lens && to.lens ? to.levels : to.places();
      double wanted = lens && to.lens ? levels.get(zoom) : place(zoom, levels.size());
      int nearest = 0;
      for (int i = 1; i < among.size(); i++) {
        boolean nearer = Math.abs(among.get(i) - wanted) <= Math.abs(among.get(nearest) - wanted);
        nearest = nearer ? i : nearest;
      }
      return nearest;
    }

    private List<Double> places() {
      int zooms = levels.size();
      return IntStream.range(0, zooms).mapToObj(i -> place(i, zooms)).toList();
    }
  }

  private final int[] kinds;
  private final boolean oneKind;
  private final int[][][] tables; // by kind, other kind, and view

  ViewTranslation(NetworkView network) {
    Map<Kind, Integer> known = new LinkedHashMap<>();
    kinds = new int[network.cameras()];
    for (int camera = 0; camera < kinds.length; camera++) {
      kinds[camera] = known.computeIfAbsent(Kind.of(network, camera), kind -> known.size());
    }
    List<Kind> all = new ArrayList<>(known.keySet());
    oneKind = all.size() == 1;
    tables = new int[all.size()][all.size()][];
    for (int from = 0; from < tables.length; from++) {
      for (int to = 0; to < tables.length; to++) {
        tables[from][to] = all.get(from).translated(all.get(to));
      }
    }
  }

  /**
   * What a neighbour answers a camera that asks for a state: its own best view in the state that is
   * nearest to it, as the asker's view that is nearest to that.
   *
   * @param state of the asker, as its view and percept make it
   */
  int answer(ActionValues q, int asker, int neighbour, int state, int view, int percept) {
    if (oneKind || kinds[asker] == kinds[neighbour]) {
      return q.best(neighbour, state);
    }
    int theirs = q.state(neighbour, view(asker, neighbour, view), percept);
    return view(neighbour, asker, q.best(neighbour, theirs));
  }

  /** The other camera's view that comes nearest to a view of a camera. */
  int view(int camera, int other, int view) {
    return tables[kinds[camera]][kinds[other]][view];
  }
}
