package org.hificamsim.core.scenario;

import java.util.HashSet;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.DoublePredicate;

/** Reads cameras, from their own element or from an event that adds one. */
final class CameraReader {
  private static final String ANGLE = "degrees above 0 and at most 360";
  private static final String RANGE = "a number of 0 or more (m)";

  private final Field field;
  private final AgentCheck agents;
  private final Consumer<String> warnings;
  private final Set<String> names = new HashSet<>();

  CameraReader(Field field, AgentCheck agents, Consumer<String> warnings) {
    this.field = field;
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
    double x = attributes.number("x", inField(field.minX(), field.maxX()), field::containsX);
    double y = attributes.number("y", inField(field.minY(), field.maxY()), field::containsY);
    double heading = attributes.number("heading");
    double angle = attributes.number("viewing_angle", ANGLE, value -> value > 0 && value <= 360);
    double range = attributes.number("range", RANGE, value -> value >= 0);
    AgentSpec agent = agent(attributes);
    agents.check(agent, added, attributes::invalid);
    return new CameraSpec(
        name,
        x,
        y,
        heading,
        angle,
        range,
        agent,
        attributes.leftOver(warnings, "min_zoom", "max_zoom", "zoom_steps"));
  }

  /** An event that changes a camera, some of whose attributes have been read already. */
  ScenarioEvent.ChangeCamera change(Attributes attributes, int step) {
    return new ScenarioEvent.ChangeCamera(
        step,
        attributes.text("name", "the name of a camera"),
        changed(attributes, "x", inField(field.minX(), field.maxX()), field::containsX),
        changed(attributes, "y", inField(field.minY(), field.maxY()), field::containsY),
        attributes.number("heading"),
        changed(attributes, "viewing_angle", ANGLE, value -> value > 0 && value <= 360),
        changed(attributes, "range", RANGE, value -> value >= 0));
  }

  private static double changed(
      Attributes attributes, String name, String expected, DoublePredicate valid) {
    return attributes.number(
        name, expected + ", or -1 to leave it", value -> value == -1 || valid.test(value));
  }

  /** The names read so far. */
  Set<String> names() {
    return new HashSet<>(names);
  }

  /** Whether a camera of this name has been read. */
  boolean knows(String name) {
    return names.contains(name);
  }

  private static String inField(double least, double most) {
    return "a number inside the field, " + least + " to " + most;
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
