package org.hificamsim.core.scenario.spec;

import java.util.List;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacle.Pillar;
import org.hificamsim.core.obstacle.Obstacle.Polygon;
import org.hificamsim.core.obstacle.Obstacle.Wall;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Type;

/** Obstacles, as scenario files have them. */
public final class ObstacleElements {
  /** The sentence about all kinds of obstacles, for the docs of each. */
  private static final String LIGHT =
      """
      transmittance: the part of the light that passes, 0 to 1; 0 is *solid*
      base: [height](world.md#heights) of its underside, m; targets walk below a base \
      above 0 (ours)
      height: height of its top, m, above the base (ours) | it hides everything
      """;

  private static final Element<Wall> WALL =
      Element.ofRecord(
              "wall",
              Wall.class,
              """
              A segment without thickness.
              x1, y1: one end, m
              x2, y2: the other end, m
              """
                  + LIGHT)
          .requires(Type.COORDINATE, "x1", "y1", "x2", "y2");

  private static final Element<Polygon> POLYGON =
      Element.ofRecord(
              "polygon",
              Polygon.class,
              """
              An area.
              points: three corners or more, m, as in `0,0 4,0 4,3`; the last is joined to the \
              first, and sides may not touch but at corners they share
              """
                  + LIGHT)
          .requires(Type.POINTS, "points");

  private static final Element<Pillar> PILLAR =
      Element.ofRecord(
              "pillar",
              Pillar.class,
              """
              A disc.
              x, y: its centre, m
              radius: m, above 0
              """
                  + LIGHT)
          .requires(Type.COORDINATE, "x", "y")
          .requires(Type.POSITIVE_LENGTH, "radius");

  /** The elements of all kinds of obstacles. */
  public static final List<Element<? extends Obstacle>> ALL = List.of(WALL, POLYGON, PILLAR);

  static {
    for (Element<?> element : ALL) {
      element.optional("transmittance", Type.PROPORTION, 0.0);
      element.optional("base", Type.LENGTH, 0.0);
      element.optional("height", Type.POSITIVE_LENGTH, Double.POSITIVE_INFINITY);
    }
  }

  private ObstacleElements() {}
}
