package org.hificamsim.core.scenario.file;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.spec.Extent;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Waypoint;
import org.hificamsim.core.scenario.xml.XmlElement;

/** Reads targets, from their own elements or from an event that adds one. */
public final class TargetReader {
  /** The movement that starts on its first waypoint and may leave the field. */
  private static final String SCRIPTED = "Scripted";

  private static final String WAYPOINTS = "Waypoints";

  private final Field field;
  private final ObstacleCheck obstacleCheck;
  private final boolean coverageDialect;
  private final Predicate<String> movements;
  private final Set<Double> features = new HashSet<>();

  /**
   * Creates a reader.
   *
   * @param coverageDialect whether paths are scripted and may leave the field
   * @param movements whether a movement of a name exists
   */
  public TargetReader(
      Field field,
      ObstacleCheck obstacleCheck,
      boolean coverageDialect,
      Predicate<String> movements) {
    this.field = field;
    this.obstacleCheck = obstacleCheck;
    this.coverageDialect = coverageDialect;
    this.movements = movements;
  }

  /** Reads a target of the start. */
  public TargetSpec object(XmlElement xml) {
    return unique(xml, object(xml, TargetSpec.ELEMENT));
  }

  /** Reads a target of the start with waypoints. */
  public TargetSpec withWaypoints(XmlElement xml) {
    Attributes<TargetSpec> attributes = new Attributes<>(xml, TargetSpec.WITH_WAYPOINTS);
    TargetSpec read = unique(xml, sized(attributes));
    List<Waypoint> path = waypoints(xml, coverageDialect);
    if (path.isEmpty()) {
      throw xml.place().error("no <waypoint>, expected at least two");
    }
    attributes.warnOfUnknown();
    return read.with(TargetSpec.ORIGIN, TargetSpec.Origin.OBJECT_WITH_WAYPOINTS)
        .with(TargetSpec.MOVE, "epics.movement.Waypoints")
        .with(TargetSpec.WAYPOINTS, path)
        .with(TargetSpec.X, path.get(0).x())
        .with(TargetSpec.Y, path.get(0).y())
        .with(TargetSpec.HEADING, -1);
  }

  /** Reads the target that an event adds. */
  public TargetSpec added(XmlElement event) {
    if (event.attributes().containsKey(TargetSpec.MOVE.name())) {
      event.warn(
          TargetSpec.MOVE.name(),
          "an event's move is ignored, as in CamSim (unless a quirk of CamSim says otherwise);"
              + " fqName counts");
    }
    return object(event, TargetSpec.ADDED).with(TargetSpec.ORIGIN, TargetSpec.Origin.EVENT);
  }

  private TargetSpec unique(XmlElement xml, TargetSpec target) {
    if (!features.add(target.features())) {
      throw xml.invalid("features", "features that no other object has");
    }
    return target;
  }

  private TargetSpec object(XmlElement xml, Element<TargetSpec> element) {
    Attributes<TargetSpec> attributes = new Attributes<>(xml, element);
    TargetSpec target = sized(attributes);
    boolean anywhere = coverageDialect || target.movement().equals(SCRIPTED);
    target = target.with(TargetSpec.WAYPOINTS, waypoints(xml, anywhere));
    checkMovement(xml, target, attributes);
    checkStart(xml, target);
    attributes.warnOfUnknown();
    return target;
  }

  /** Reads a target with its size, or with its width and height. */
  private static TargetSpec sized(Attributes<TargetSpec> attributes) {
    TargetSpec target = attributes.read();
    if (!attributes.has(TargetSpec.WIDTH) && !attributes.has(TargetSpec.HEIGHT)) {
      return target;
    }
    attributes.refuse(
        TargetSpec.SIZE, "none together with width and height, from which it follows");
    return target.withExtent(
        new Extent(attributes.require(TargetSpec.WIDTH), attributes.require(TargetSpec.HEIGHT)));
  }

  private void checkMovement(XmlElement xml, TargetSpec target, Attributes<TargetSpec> attributes) {
    String movement = target.movement();
    if (!movements.test(movement) || movement.equals(TargetSpec.TRACKS)) {
      throw attributes.invalid(TargetSpec.MOVE, TargetSpec.MOVE.type().expected());
    }
    if (target.lacksWaypoints()) {
      throw xml.place()
          .error("movement " + movement + " without <waypoint>, expected at least two of them");
    }
  }

  private void checkStart(XmlElement xml, TargetSpec target) {
    boolean scripted = target.movement().equals(SCRIPTED);
    boolean onPath = target.movement().equals(WAYPOINTS);
    boolean fromFirst = scripted || (onPath && target.get(TargetSpec.MOVE).isEmpty());
    Waypoint start = fromFirst ? target.waypoints().get(0) : new Waypoint(target.x(), target.y());
    obstacleCheck.requireFree(xml, start.x(), start.y());
    if (!field.contains(start.x(), start.y()) && !scripted && !(onPath && coverageDialect)) {
      xml.warn(
          "x",
          "<%s> starts outside the field at (%s, %s); it stays there, turning, unless one step"
                  .formatted(xml.name(), start.x(), start.y())
              + " leads inside");
    }
  }

  /**
   * @param anywhere whether waypoints may lie outside the field
   */
  private List<Waypoint> waypoints(XmlElement xml, boolean anywhere) {
    List<XmlElement> children = xml.all(Waypoint.ELEMENT.name());
    if (children.size() == 1) {
      throw children.get(0).place().error("one <waypoint>, expected none or at least two");
    }
    List<Waypoint> path = children.stream().map(child -> waypoint(child, anywhere)).toList();
    obstacleCheck.warnOfPath(xml, path);
    return path;
  }

  private Waypoint waypoint(XmlElement xml, boolean anywhere) {
    Waypoint waypoint = Attributes.read(xml, Waypoint.ELEMENT);
    obstacleCheck.requireFree(xml, waypoint.x(), waypoint.y());
    if (!field.contains(waypoint.x(), waypoint.y()) && !anywhere) {
      xml.warn("<waypoint> lies outside the field, out of reach");
    }
    return waypoint;
  }
}
