package org.hificamsim.core.scenario;

import java.util.List;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacle.Pillar;
import org.hificamsim.core.obstacle.Obstacle.Polygon;
import org.hificamsim.core.obstacle.Obstacle.Wall;

/** Obstacles, as scenario files have them. */
final class ObstacleElements {
  /** All of them. */
  static final List<Element<? extends Obstacle>> ALL = List.of(wall(), polygon(), pillar());

  private ObstacleElements() {}

  private static Element<Wall> wall() {
    Element<Wall> wall =
        element(
            "wall",
            Wall.class,
            """
            A segment without thickness.
            x1, y1: one end, m
            x2, y2: the other end, m
            """);
    wall.required("x1", Type.COORDINATE);
    wall.required("y1", Type.COORDINATE);
    wall.required("x2", Type.COORDINATE);
    wall.required("y2", Type.COORDINATE);
    return withLight(wall);
  }

  private static Element<Polygon> polygon() {
    Element<Polygon> polygon =
        element(
            "polygon",
            Polygon.class,
            """
            An area.
            points: three corners or more, m, as in `0,0 4,0 4,3`; the last is joined to the \
            first, and sides may not touch but at corners they share
            """);
    polygon.required("points", Type.POINTS);
    return withLight(polygon);
  }

  private static Element<Pillar> pillar() {
    Element<Pillar> pillar =
        element(
            "pillar",
            Pillar.class,
            """
            A disc.
            x, y: its centre, m
            radius: m, above 0
            """);
    pillar.required("x", Type.COORDINATE);
    pillar.required("y", Type.COORDINATE);
    pillar.required("radius", Type.POSITIVE_LENGTH);
    return withLight(pillar);
  }

  private static <O extends Record> Element<O> element(String name, Class<O> type, String doc) {
    return Element.ofRecord(
        name,
        type,
        doc
            + """
              transmittance: the part of the light that passes, 0 to 1; 0 is *solid*
              base: [height](world.md#heights) of its underside, m; targets walk below a base \
              above 0 (ours)
              height: height of its top, m, above the base (ours) | it hides everything
              """);
  }

  private static <O> Element<O> withLight(Element<O> element) {
    element.attribute("transmittance", Type.PROPORTION, 0.0).quiet();
    element.attribute("base", Type.LENGTH, 0.0).quiet();
    element.attribute("height", Type.POSITIVE_LENGTH, Double.POSITIVE_INFINITY).quiet();
    return element;
  }
}
