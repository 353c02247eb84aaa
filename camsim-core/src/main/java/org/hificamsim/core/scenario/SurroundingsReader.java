package org.hificamsim.core.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;

/** Reads obstacles, occlusion and the floorplan. */
final class SurroundingsReader {
  private static final Set<String> OBSTACLES = Set.of("wall", "polygon", "pillar");

  private static final List<String> BORDERS =
      List.of("floorplan_min_x", "floorplan_max_x", "floorplan_min_y", "floorplan_max_y");

  private final XmlElement root;
  private final Field field;
  private final Consumer<String> warnings;
  private final Faults faults;

  SurroundingsReader(XmlElement root, Field field, Consumer<String> warnings, Faults faults) {
    this.root = root;
    this.field = field;
    this.warnings = warnings;
    this.faults = faults;
  }

  /**
   * Reads them all.
   *
   * @param simulation whose attributes say the rest
   */
  Surroundings surroundings(Attributes simulation) {
    List<XmlElement> elements =
        root.below().filter(element -> OBSTACLES.contains(element.name())).toList();
    Occlusion occlusion =
        faults.of(() -> simulation.choice("occlusion", Occlusion.NONE)).orElse(Occlusion.NONE);
    Optional<Floorplan> floorplan = faults.of(() -> floorplan(simulation)).orElse(Optional.empty());
    return new Surroundings(faults.each(elements, this::obstacle), occlusion, floorplan);
  }

  private Obstacle obstacle(XmlElement element) {
    Attributes attributes = new Attributes(element);
    double transmittance = attributes.optionalNumber("transmittance", Range.PROPORTION).orElse(0);
    Obstacle obstacle =
        shaped(
            element,
            switch (element.name()) {
              case "wall" -> wall(attributes);
              case "pillar" -> pillar(attributes);
              default -> polygon(attributes);
            },
            transmittance);
    attributes.leftOver(warnings);
    return obstacle;
  }

  /** What is wrong with a shape as a whole is reported with the element's place. */
  private static Obstacle shaped(
      XmlElement element, Function<Double, Obstacle> shape, double transmittance) {
    try {
      return shape.apply(transmittance);
    } catch (IllegalArgumentException e) {
      throw element.place().error("<" + element.name() + "> " + e.getMessage());
    }
  }

  private static Function<Double, Obstacle> wall(Attributes attributes) {
    double x1 = attributes.number("x1", Range.COORDINATE);
    double y1 = attributes.number("y1", Range.COORDINATE);
    double x2 = attributes.number("x2", Range.COORDINATE);
    double y2 = attributes.number("y2", Range.COORDINATE);
    return transmittance -> new Obstacle.Wall(x1, y1, x2, y2, transmittance);
  }

  private static Function<Double, Obstacle> pillar(Attributes attributes) {
    double x = attributes.number("x", Range.COORDINATE);
    double y = attributes.number("y", Range.COORDINATE);
    double radius = attributes.number("radius", Range.POSITIVE_LENGTH);
    return transmittance -> new Obstacle.Pillar(x, y, radius, transmittance);
  }

  private static Function<Double, Obstacle> polygon(Attributes attributes) {
    String expected =
        "corners as in 0,0 4,0 4,3; three or more, each coordinate " + Range.COORDINATE.expected();
    List<Point> points = new ArrayList<>();
    for (String corner : attributes.text("points", expected).strip().split("\\s+")) {
      String[] parts = corner.split(",", -1);
      if (parts.length != 2) {
        throw attributes.invalid("points", expected);
      }
      points.add(
          new Point(
              coordinate(attributes, parts[0], expected),
              coordinate(attributes, parts[1], expected)));
    }
    return transmittance -> new Obstacle.Polygon(points, transmittance);
  }

  private static double coordinate(Attributes attributes, String text, String expected) {
    try {
      double value = Double.parseDouble(text);
      if (Range.COORDINATE.contains(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw attributes.invalid("points", expected);
  }

  /** Without an area of its own it shows the field. */
  private Optional<Floorplan> floorplan(Attributes simulation) {
    Optional<String> file = simulation.optionalText("floorplan");
    if (file.isEmpty()) {
      BORDERS.forEach(border -> simulation.refuse(border, "none without floorplan"));
      return Optional.empty();
    }
    Field area =
        new Field(
            simulation.optionalNumber("floorplan_min_x", Range.COORDINATE).orElse(field.minX()),
            simulation.optionalNumber("floorplan_max_x", Range.COORDINATE).orElse(field.maxX()),
            simulation.optionalNumber("floorplan_min_y", Range.COORDINATE).orElse(field.minY()),
            simulation.optionalNumber("floorplan_max_y", Range.COORDINATE).orElse(field.maxY()));
    if (!(area.width() > 0)) {
      throw simulation.invalid("floorplan_max_x", "more than floorplan_min_x, " + area.minX());
    }
    if (!(area.height() > 0)) {
      throw simulation.invalid("floorplan_max_y", "more than floorplan_min_y, " + area.minY());
    }
    return Optional.of(new Floorplan(file.get(), area));
  }
}
