package org.hificamsim.presentation.replay;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.obstacle.VisibleRegion;
import org.hificamsim.core.scenario.Field;

/** What solid obstacles leave in sight, as corners to be drawn. */
final class Outlook {
  /** Beyond what a camera reaches, so that few corners do where nothing is in the way. */
  private static final double BEYOND = 1.1;

  /** Of the way round: between corners where nothing is in the way. */
  private static final double ARC = 2 * Math.PI / 24;

  private final List<Obstacle> obstacles;
  private final Map<Double, Obstacles> hiding = new HashMap<>(); // by a camera's height
  private final Scale scale;

  Outlook(List<Obstacle> obstacles, Field field) {
    this.obstacles = obstacles;
    this.scale = Scale.of(field);
  }

  /**
   * The corners as in {@link CameraPose#visible}; the place itself where a camera sees nothing.
   *
   * @param z of the camera, metres; NaN in a flat world
   * @param reach of the camera, metres
   */
  List<Double> from(double x, double y, double z, double reach) {
    Obstacles walls = hiding.computeIfAbsent(z, this::hiding);
    if (walls.isEmpty() || !(reach > 0)) {
      return List.of();
    }
    double most = BEYOND * reach;
    List<Point> corners = VisibleRegion.of(walls, x, y, most).polygon(most);
    return rounded(corners.isEmpty() ? List.of(new Point(x, y)) : fewer(corners, x, y, most));
  }

  /** Those that a camera cannot look over, as if they had no top. */
  private Obstacles hiding(double z) {
    return new Obstacles(
        obstacles.stream()
            .filter(one -> one.solid() && (one.full() || (one.base() == 0 && one.height() >= z)))
            .map(one -> one.between(0, Double.POSITIVE_INFINITY))
            .toList());
  }

  /** Leaves out most corners of arcs about the camera. */
  private static List<Point> fewer(List<Point> corners, double x, double y, double reach) {
    List<Point> kept = new ArrayList<>();
    double last = Double.NaN;
    for (int i = 0; i < corners.size(); i++) {
      Point corner = corners.get(i);
      double angle = Math.atan2(corner.y() - y, corner.x() - x);
      boolean onArc =
          isFar(corner, x, y, reach) && isFar(corners.get((i + 1) % corners.size()), x, y, reach);
      if (!onArc || !(Math.abs(angle - last) < ARC)) {
        kept.add(corner);
        last = isFar(corner, x, y, reach) ? angle : Double.NaN;
      }
    }
    return kept;
  }

  private static boolean isFar(Point corner, double x, double y, double reach) {
    return Math.hypot(corner.x() - x, corner.y() - y) > reach * (1 - 1e-9);
  }

  private List<Double> rounded(List<Point> corners) {
    return corners.stream()
        .flatMap(corner -> List.of(rounded(corner.x()), rounded(corner.y())).stream())
        .toList();
  }

  private double rounded(double metres) {
    return scale.unpack(scale.pack(metres));
  }
}
