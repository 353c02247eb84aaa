package org.hificamsim.core.scenario.spec;

import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Type;

/** A corner of a target's path, in metres. */
public record Waypoint(double x, double y) {
  public static final Element<Waypoint> ELEMENT =
      Element.ofRecord(
              "waypoint",
              Waypoint.class,
              """
              A corner of a path.
              x, y: place to walk to, m
              """)
          .requires(Type.COORDINATE, "x", "y");
}
