package org.hificamsim.core.scenario;

import java.util.HashSet;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Consumer;

/** Reads cameras, from their own element or from an event that adds one. */
final class CameraReader {
  static final String ANGLE = "degrees above 0 and at most 360";
  static final String RANGE = "a number of 0 or more (m)";

  private final Field field;
  private final Consumer<String> warnings;
  private final Set<String> names = new HashSet<>();

  CameraReader(Field field, Consumer<String> warnings) {
    this.field = field;
    this.warnings = warnings;
  }

  CameraSpec camera(XmlElement element) {
    return camera(element, new Attributes(element));
  }

  /** The camera of an element, some of whose attributes have been read already. */
  CameraSpec camera(XmlElement element, Attributes attributes) {
    String name = attributes.text("name");
    if (!names.add(name)) {
      throw attributes.invalid("name", name, "a camera name that is not taken");
    }
    double x = coordinate(attributes, "x", field.minX(), field.maxX());
    double y = coordinate(attributes, "y", field.minY(), field.maxY());
    double heading = attributes.number("heading");
    double angle = attributes.number("viewing_angle", ANGLE, value -> value > 0 && value <= 360);
    double range = attributes.number("range", RANGE, value -> value >= 0);
    AgentSpec agent = agent(attributes);
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

  /** Whether a camera of this name has been read. */
  boolean knows(String name) {
    return names.contains(name);
  }

  private static double coordinate(Attributes attributes, String name, double least, double most) {
    return attributes.number(
        name,
        "a number inside the field, " + least + " to " + most,
        value -> value >= least && value <= most);
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
