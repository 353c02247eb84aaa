package org.hificamsim.core.scenario;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Consumer;

/** Reads cameras, from their own element or from an event that adds one. */
final class CameraReader {
  private final Range across;
  private final Range along;
  private final Clearing clearing;
  private final OpticsReader optics;
  private final AgentCheck agents;
  private final Consumer<String> warnings;
  private final Set<String> names = new HashSet<>();

  CameraReader(
      Field field,
      Clearing clearing,
      OpticsReader optics,
      AgentCheck agents,
      Consumer<String> warnings) {
    this.clearing = clearing;
    this.optics = optics;
    across = inField(field.minX(), field.maxX());
    along = inField(field.minY(), field.maxY());
    this.agents = agents;
    this.warnings = warnings;
  }

  CameraSpec camera(XmlElement element) {
    return camera(new Attributes(element), false);
  }

  /** The camera that an event adds; the event's own attributes have been read already. */
  CameraSpec added(Attributes attributes) {
    return camera(attributes, true);
  }

  private CameraSpec camera(Attributes attributes, boolean added) {
    String name = attributes.text("name", "a name that no other camera has");
    if (!names.add(name)) {
      throw attributes.invalid("name", "a camera name that is not taken");
    }
    double x = attributes.number("x", across);
    double y = attributes.number("y", along);
    clearing.requireFree(attributes, x, y);
    double heading = attributes.number("heading");
    Optional<OpticsSpec> itsOptics = optics.named(attributes);
    double angle = viewingAngle(attributes, itsOptics);
    double range = range(attributes, itsOptics);
    AgentSpec agent = agent(attributes);
    agents.check(agent, itsOptics, added, attributes::invalid);
    return new CameraSpec(
        name,
        x,
        y,
        heading,
        angle,
        range,
        agent,
        itsOptics,
        attributes.leftOver(warnings, "min_zoom", "max_zoom", "zoom_steps"));
  }

  /** A camera with a lens needs none: it has its widest angle of view. */
  private static double viewingAngle(Attributes attributes, Optional<OpticsSpec> optics) {
    List<Double> angles = optics.map(OpticsSpec::anglesOfView).orElse(List.of());
    return angles.isEmpty() || attributes.has("viewing_angle")
        ? attributes.number("viewing_angle", Range.OPENING_ANGLE)
        : angles.get(angles.size() - 1);
  }

  /** A camera with a lens needs none: it has its reach, or 0 for one without an end. */
  private static double range(Attributes attributes, Optional<OpticsSpec> optics) {
    return optics.filter(one -> one.law().hasAngles()).isEmpty() || attributes.has("range")
        ? attributes.number("range", Range.LENGTH)
        : optics.get().reach().orElse(0);
  }

  /** An event that changes a camera, some of whose attributes have been read already. */
  ScenarioEvent.ChangeCamera change(Attributes attributes, int step) {
    String name = attributes.text("name", "the name of a camera");
    double x = attributes.number("x", across.orUnchanged());
    double y = attributes.number("y", along.orUnchanged());
    return new ScenarioEvent.ChangeCamera(
        step,
        name,
        x,
        y,
        attributes.number("heading"),
        attributes.number("viewing_angle", Range.OPENING_ANGLE.orUnchanged()),
        attributes.number("range", Range.LENGTH.orUnchanged()));
  }

  /** Where a change puts a camera, off all obstacles. */
  Waypoint moved(XmlElement element, ScenarioEvent.ChangeCamera change, Waypoint before) {
    double x = change.x() == -1 ? before.x() : change.x();
    double y = change.y() == -1 ? before.y() : change.y();
    clearing.requireFree(new Attributes(element), x, y);
    return new Waypoint(x, y);
  }

  /** Whether a camera of this name has been read. */
  boolean knows(String name) {
    return names.contains(name);
  }

  private static Range inField(double min, double max) {
    return new Range(
        "a number inside the field, " + min + " to " + max, value -> value >= min && value <= max);
  }

  private static AgentSpec agent(Attributes attributes) {
    OptionalInt limit = attributes.optionalInteger("limit", 0, Integer.MAX_VALUE);
    Optional<String> bandit = attributes.optionalText("bandit").filter(text -> !text.isEmpty());
    return new AgentSpec(
        attributes.optionalText("ai_algorithm"),
        attributes.optionalInteger("comm", 0, 4),
        attributes.optionalText("customcom"),
        limit.orElse(0),
        bandit);
  }
}
