package org.hificamsim.core.scenario;

import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.declaration.Spec;
import org.hificamsim.core.scenario.file.Attributes;
import org.hificamsim.core.scenario.spec.Field;

/**
 * The attributes of a scenario that are the borders of an area.
 *
 * @param sides west, east, south and north
 */
record Borders(List<Property<Scenario, Double>> sides) {
  /**
   * Declares the attributes.
   *
   * @param declare makes the attribute of a name, such as {@code min_x}
   */
  static Borders of(Function<String, Property<Scenario, Double>> declare) {
    return new Borders(Stream.of("min_x", "max_x", "min_y", "max_y").map(declare).toList());
  }

  /** The area between the borders. */
  Field area(Function<Property<Scenario, Double>, Double> value) {
    List<Double> values = sides.stream().map(value).toList();
    return new Field(values.get(0), values.get(1), values.get(2), values.get(3));
  }

  /** Fails unless the area has a width and a height. */
  void check(Attributes<Scenario> attributes, Function<Property<Scenario, Double>, Double> value) {
    Field area = area(value);
    String more = "more than %s, %s";
    if (!(area.width() > 0)) {
      String expected = more.formatted(sides.get(0).name(), area.minX());
      throw attributes.invalid(sides.get(1), expected);
    }
    if (!(area.height() > 0)) {
      String expected = more.formatted(sides.get(2).name(), area.minY());
      throw attributes.invalid(sides.get(3), expected);
    }
  }

  /** Returns the spec with another area. */
  Spec<Scenario> put(Spec<Scenario> spec, Field area) {
    return spec.put(sides.get(0), area.minX())
        .put(sides.get(1), area.maxX())
        .put(sides.get(2), area.minY())
        .put(sides.get(3), area.maxY());
  }

  /** Returns the scenario without the attributes. */
  Scenario without(Scenario scenario) {
    Scenario rest = scenario;
    for (Property<Scenario, Double> border : sides) {
      rest = rest.without(border);
    }
    return rest;
  }
}
