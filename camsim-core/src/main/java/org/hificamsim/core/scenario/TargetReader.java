package org.hificamsim.core.scenario;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;

/** Reads targets, from their own element or from an event that adds one. */
final class TargetReader {
  /** A movement that starts on its first waypoint, and may leave the field. */
  private static final String SCRIPTED = "Scripted";

  private final Field field;
  private final Clearing clearing;
  private final boolean coverageDialect;
  private final Predicate<String> movements;
  private final Consumer<String> warnings;
  private final Set<Double> features = new HashSet<>();

  /**
   * @param coverageDialect whether paths are scripted and may leave the field
   */
  TargetReader(
      Field field,
      Clearing clearing,
      boolean coverageDialect,
      Predicate<String> movements,
      Consumer<String> warnings) {
    this.field = field;
    this.clearing = clearing;
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
    double speed = attributes.number("speed", Range.SPEED);
    Optional<Extent> extent = extent(attributes);
    double size = size(attributes, extent);
    List<Waypoint> waypoints = waypoints(element, coverageDialect);
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
        extent,
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
    Waypoint position = point(attributes);
    double heading = attributes.number("heading");
    double speed = attributes.number("speed", Range.SPEED);
    Optional<Extent> extent = extent(attributes);
    double size = size(attributes, extent);
    MovementSpec spec = movement(element, attributes, origin, movement);
    boolean scripted = spec.shortName().equals(SCRIPTED);
    boolean onPath = spec.shortName().equals("Waypoints");
    boolean fromFirst = scripted || (onPath && movement.isEmpty());
    Waypoint start = fromFirst ? spec.waypoints().get(0) : position;
    clearing.requireFree(new Attributes(element), start.x(), start.y());
    if (!field.contains(start.x(), start.y()) && !scripted && !(onPath && coverageDialect)) {
      warnings.accept(
          "%s: <%s> starts outside the field at (%s, %s); it stays there, turning, unless one step"
                  .formatted(element.place("x"), element.name(), start.x(), start.y())
              + " leads inside");
    }
    return new TargetSpec(
        origin,
        identity,
        position.x(),
        position.y(),
        heading,
        speed,
        size,
        extent,
        spec,
        attributes.leftOver(warnings, "move"));
  }

  private MovementSpec movement(
      XmlElement element, Attributes attributes, TargetSpec.Origin origin, String name) {
    double mean = attributes.optionalNumber("mean", Range.COORDINATE).orElse(0);
    double std = attributes.optionalNumber("std", Range.LENGTH).orElse(1);
    boolean anywhere = coverageDialect || MovementSpec.shortName(name).equals(SCRIPTED);
    List<Waypoint> path = waypoints(element, anywhere);
    MovementSpec spec = new MovementSpec(name, mean, std, path);
    if (!movements.test(spec.shortName()) || spec.shortName().equals(MovementSpec.TRACKS)) {
      throw attributes.invalid(
          origin == TargetSpec.Origin.EVENT ? "fqName" : "move",
          "a movement such as Straight, Waypoints, Brownian, DirectedBrownian, or one in a jar");
    }
    if (spec.lacksWaypoints()) {
      throw element
          .place()
          .error(
              "movement "
                  + spec.shortName()
                  + " without <waypoint>, expected at least two of them");
    }
    return spec;
  }

  private static Waypoint point(Attributes attributes) {
    return new Waypoint(
        attributes.number("x", Range.COORDINATE), attributes.number("y", Range.COORDINATE));
  }

  private double identity(Attributes attributes) {
    double identity = attributes.number("features");
    if (!features.add(identity)) {
      throw attributes.invalid("features", "features that no other object has");
    }
    return identity;
  }

  private static double size(Attributes attributes, Optional<Extent> extent) {
    if (extent.isPresent()) {
      attributes.refuse("size", "none beside width and height, from which it follows");
    }
    double standard = extent.map(Extent::size).orElse(TargetSpec.DEFAULT_SIZE);
    return attributes.optionalNumber("size", Range.POSITIVE_LENGTH).orElse(standard);
  }

  private static Optional<Extent> extent(Attributes attributes) {
    if (!attributes.has("width") && !attributes.has("height")) {
      return Optional.empty();
    }
    return Optional.of(
        new Extent(
            attributes.number("width", Range.POSITIVE_LENGTH),
            attributes.number("height", Range.POSITIVE_LENGTH)));
  }

  /**
   * @param anywhere whether they may lie outside the field
   */
  private List<Waypoint> waypoints(XmlElement element, boolean anywhere) {
    List<XmlElement> children = element.all("waypoint");
    if (children.size() == 1) {
      throw children.get(0).place().error("one <waypoint>, expected none or at least two");
    }
    List<Waypoint> path = children.stream().map(child -> waypoint(child, anywhere)).toList();
    clearing.warnOfPath(element, path);
    return path;
  }

  private Waypoint waypoint(XmlElement element, boolean anywhere) {
    Attributes attributes = new Attributes(element);
    Waypoint waypoint = point(attributes);
    attributes.leftOver(warnings);
    clearing.requireFree(new Attributes(element), waypoint.x(), waypoint.y());
    if (!field.contains(waypoint.x(), waypoint.y()) && !anywhere) {
      warnings.accept(element.place() + ": <waypoint> lies outside the field, out of reach");
    }
    return waypoint;
  }

  /** The features of the targets that are there at the start. */
  Set<Double> present() {
    return new HashSet<>(features);
  }
}
