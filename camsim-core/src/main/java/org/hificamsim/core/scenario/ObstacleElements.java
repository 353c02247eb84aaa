package org.hificamsim.core.scenario;

import java.util.List;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacle.Pillar;
import org.hificamsim.core.obstacle.Obstacle.Polygon;
import org.hificamsim.core.obstacle.Obstacle.Wall;
import org.hificamsim.core.obstacle.Point;

/** Obstacles, as scenario files have them. */
final class ObstacleElements {
  private static final String TRANSMITTANCE =
      "transmittance: the part of the light that passes, 0 to 1; 0 is *solid*\n";

  private static final Element<Wall> WALL =
      new Element<>(
          "wall",
          Wall.class,
          ObstacleElements::wall,
          ObstacleElements::said,
          """
          A segment without thickness.
          x1, y1: one end, m
          x2, y2: the other end, m
          """
              + TRANSMITTANCE);
  private static final Property<Wall, Double> X1 = WALL.required("x1", Type.COORDINATE);
  private static final Property<Wall, Double> Y1 = WALL.required("y1", Type.COORDINATE);
  private static final Property<Wall, Double> X2 = WALL.required("x2", Type.COORDINATE);
  private static final Property<Wall, Double> Y2 = WALL.required("y2", Type.COORDINATE);
  private static final Property<Wall, Double> OF_WALL = transmittance(WALL);

  private static final Element<Polygon> POLYGON =
      new Element<>(
          "polygon",
          Polygon.class,
          said ->
              new Polygon(said.get(ObstacleElements.POINTS), said.get(ObstacleElements.OF_POLYGON)),
          ObstacleElements::said,
          """
          An area.
          points: three corners or more, m, as in `0,0 4,0 4,3`; the last is joined to the first, \
          and sides may not touch but at corners they share
          """
              + TRANSMITTANCE);
  private static final Property<Polygon, List<Point>> POINTS =
      POLYGON.required("points", Type.POINTS);
  private static final Property<Polygon, Double> OF_POLYGON = transmittance(POLYGON);

  private static final Element<Pillar> PILLAR =
      new Element<>(
          "pillar",
          Pillar.class,
          ObstacleElements::pillar,
          ObstacleElements::said,
          """
          A disc.
          x, y: its centre, m
          radius: m, above 0
          """
              + TRANSMITTANCE);
  private static final Property<Pillar, Double> X = PILLAR.required("x", Type.COORDINATE);
  private static final Property<Pillar, Double> Y = PILLAR.required("y", Type.COORDINATE);
  private static final Property<Pillar, Double> RADIUS =
      PILLAR.required("radius", Type.POSITIVE_LENGTH);
  private static final Property<Pillar, Double> OF_PILLAR = transmittance(PILLAR);

  /** All of them. */
  static final List<Element<? extends Obstacle>> ALL = List.of(WALL, POLYGON, PILLAR);

  private ObstacleElements() {}

  private static <O> Property<O, Double> transmittance(Element<O> element) {
    return element.attribute("transmittance", Type.PROPORTION, 0.0).quiet();
  }

  private static Wall wall(Spec<Wall> said) {
    return new Wall(said.get(X1), said.get(Y1), said.get(X2), said.get(Y2), said.get(OF_WALL));
  }

  private static Spec<Wall> said(Wall wall) {
    return WALL.empty()
        .put(X1, wall.x1())
        .put(Y1, wall.y1())
        .put(X2, wall.x2())
        .put(Y2, wall.y2())
        .put(OF_WALL, wall.transmittance());
  }

  private static Spec<Polygon> said(Polygon polygon) {
    return POLYGON.empty().put(POINTS, polygon.points()).put(OF_POLYGON, polygon.transmittance());
  }

  private static Pillar pillar(Spec<Pillar> said) {
    return new Pillar(said.get(X), said.get(Y), said.get(RADIUS), said.get(OF_PILLAR));
  }

  private static Spec<Pillar> said(Pillar pillar) {
    return PILLAR
        .empty()
        .put(X, pillar.x())
        .put(Y, pillar.y())
        .put(RADIUS, pillar.radius())
        .put(OF_PILLAR, pillar.transmittance());
  }
}
