package org.hificamsim.core.scenario;

/** A corner of a target's path, metres. */
public record Waypoint(double x, double y) {
  static final Element<Waypoint> ELEMENT =
      new Element<>(
          "waypoint",
          Waypoint.class,
          said -> new Waypoint(said.get(Waypoint.X), said.get(Waypoint.Y)),
          corner -> Waypoint.ELEMENT.empty().put(Waypoint.X, corner.x).put(Waypoint.Y, corner.y),
          """
          A corner of a path.
          x, y: place to walk to, m
          """);
  private static final Property<Waypoint, Double> X = ELEMENT.required("x", Type.COORDINATE);
  private static final Property<Waypoint, Double> Y = ELEMENT.required("y", Type.COORDINATE);
}
