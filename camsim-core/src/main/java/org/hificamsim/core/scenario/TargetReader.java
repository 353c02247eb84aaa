package org.hificamsim.core.scenario;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;

/** Reads targets, from their own element or from an event that adds one. */
final class TargetReader {
  private final Field field;
  private final boolean coverageDialect;
  private final Predicate<String> movements;
  private final Consumer<String> warnings;
  private final Set<Double> features = new HashSet<>();

  /**
   * @param coverageDialect whether paths are scripted and may leave the field
   */
  TargetReader(
      Field field,
      boolean coverageDialect,
      Predicate<String> movements,
      Consumer<String> warnings) {
    this.field = field;
    this.coverageDialect = coverageDialect;
    this.movements = movements;
    this.warnings = warnings;
  }

  TargetSpec object(XmlElement element) {
    Attributes attributes = new Attributes(element);
    double identity = identity(attributes);
    String movement = attributes.optionalText("move").orElse("epics.movement.Straight");
    return target(element, attributes, TargetSpec.Origin.OBJECT, identity, movement);
  }

  TargetSpec objectWithWaypoints(XmlElement element) {
    Attributes attributes = new Attributes(element);
    double identity = identity(attributes);
    double speed = attributes.number("speed");
    double size = size(attributes);
    List<Waypoint> waypoints = waypoints(element);
    if (waypoints.isEmpty()) {
      throw element.place().error("no <waypoint>, expected at least two");
    }
    return new TargetSpec(
        TargetSpec.Origin.OBJECT_WITH_WAYPOINTS,
        identity,
        waypoints.get(0).x(),
        waypoints.get(0).y(),
        -1,
        speed,
        size,
        new MovementSpec("epics.movement.Waypoints", 0, 1, waypoints),
        attributes.leftOver(warnings));
  }

  /** The target that an event adds; the event's own attributes have been read already. */
  TargetSpec added(XmlElement event, Attributes attributes, double identity) {
    String movement = attributes.optionalText("fqName").orElse("");
    return target(event, attributes, TargetSpec.Origin.EVENT, identity, movement);
  }

  private TargetSpec target(
      XmlElement element,
      Attributes attributes,
      TargetSpec.Origin origin,
      double identity,
      String movement) {
    double x = attributes.number("x");
    double y = attributes.number("y");
    double heading = attributes.number("heading");
    double speed = attributes.number("speed");
    double size = size(attributes);
    double mean = attributes.number("mean", 0, "a finite number", value -> true);
    double std = attributes.number("std", 1, "a number of 0 or more", value -> value >= 0);
    MovementSpec spec = new MovementSpec(movement, mean, std, waypoints(element));
    if (!movements.test(spec.shortName())) {
      throw attributes.invalid(
          origin == TargetSpec.Origin.EVENT ? "fqName" : "move",
          "a movement such as Straight, Waypoints, Brownian, DirectedBrownian, or one in a jar");
    }
    boolean onPath = spec.shortName().equals("Waypoints");
    if (spec.waypoints().isEmpty() && (onPath || spec.shortName().equals("Scripted"))) {
      throw element
          .place()
          .error(
              "movement "
                  + spec.shortName()
                  + " without <waypoint>, expected at least two of them");
    }
    Waypoint start = onPath && movement.isEmpty() ? spec.waypoints().get(0) : new Waypoint(x, y);
    if (!field.contains(start.x(), start.y()) && !(onPath && coverageDialect)) {
      warnings.accept(
          element.place("x")
              + ": <"
              + element.name()
              + "> starts outside the field at ("
              + start.x()
              + ", "
              + start.y()
              + "); it stays there, turning, unless one step leads inside");
    }
    return new TargetSpec(
        origin, identity, x, y, heading, speed, size, spec, attributes.leftOver(warnings, "move"));
  }

  private double identity(Attributes attributes) {
    double identity = attributes.number("features");
    if (!features.add(identity)) {
      throw attributes.invalid("features", "features that no other object has");
    }
    return identity;
  }

  private static double size(Attributes attributes) {
    return attributes.number(
        "size", TargetSpec.DEFAULT_SIZE, "a number above 0 (m)", value -> value > 0);
  }

  private List<Waypoint> waypoints(XmlElement element) {
    List<XmlElement> children = element.all("waypoint");
    if (children.size() == 1) {
      throw children.get(0).place().error("one <waypoint>, expected none or at least two");
    }
    return children.stream().map(this::waypoint).toList();
  }

  private Waypoint waypoint(XmlElement element) {
    Attributes attributes = new Attributes(element);
    Waypoint waypoint = new Waypoint(attributes.number("x"), attributes.number("y"));
    attributes.leftOver(warnings);
    if (!field.contains(waypoint.x(), waypoint.y()) && !coverageDialect) {
      warnings.accept(element.place() + ": <waypoint> lies outside the field, out of reach");
    }
    return waypoint;
  }

  /** The features of the targets that are there at the start. */
  Set<Double> present() {
    return new HashSet<>(features);
  }
}
