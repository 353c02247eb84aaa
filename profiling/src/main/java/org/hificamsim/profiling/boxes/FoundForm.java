package org.hificamsim.profiling.boxes;

import java.util.Arrays;
import java.util.List;

/** The forms of the probability that a person is found, the simplest first. */
enum FoundForm {
  CONSTANT,
  HEIGHT(Part.HEIGHT),
  HIDDEN(Part.HIDDEN),
  BOTH(Part.HEIGHT, Part.HIDDEN),
  /** A form in which even the largest boxes are not always found. */
  BOTH_WITH_CEILING(Part.HEIGHT, Part.HIDDEN, Part.CEILING),
  /** A form in which even the smallest boxes are sometimes found. */
  BOTH_WITH_FLOOR(Part.HEIGHT, Part.HIDDEN, Part.FLOOR),
  BOTH_WITH_LIMITS(Part.HEIGHT, Part.HIDDEN, Part.FLOOR, Part.CEILING),
  /** A form in which wider boxes of the same height are found more surely. */
  WIDTH(Part.HEIGHT, Part.HIDDEN, Part.WIDTH),
  WIDTH_WITH_CEILING(Part.HEIGHT, Part.HIDDEN, Part.WIDTH, Part.CEILING),
  WIDTH_WITH_FLOOR(Part.HEIGHT, Part.HIDDEN, Part.WIDTH, Part.FLOOR),
  WIDTH_WITH_LIMITS(Part.HEIGHT, Part.HIDDEN, Part.WIDTH, Part.FLOOR, Part.CEILING);

  private enum Part {
    HEIGHT,
    HIDDEN,
    WIDTH,
    FLOOR,
    CEILING
  }

  private final boolean height;
  private final boolean hidden;
  private final boolean width;
  private final boolean floor;
  private final boolean ceiling;

  FoundForm(Part... parts) {
    List<Part> given = List.of(parts);
    height = given.contains(Part.HEIGHT);
    hidden = given.contains(Part.HIDDEN);
    width = given.contains(Part.WIDTH);
    floor = given.contains(Part.FLOOR);
    ceiling = given.contains(Part.CEILING);
  }

  boolean hasHeight() {
    return height;
  }

  boolean hasHidden() {
    return hidden;
  }

  boolean hasWidth() {
    return width;
  }

  boolean hasFloor() {
    return floor;
  }

  boolean hasCeiling() {
    return ceiling;
  }

  /** The forms that a model may have, the simplest first. */
  static List<FoundForm> models() {
    return Arrays.stream(values()).filter(form -> form.height && form.hidden).toList();
  }

  /** The same form with or without the width. */
  FoundForm withWidth(boolean counts) {
    return models().stream()
        .filter(form -> form.width == counts)
        .filter(form -> form.floor == floor && form.ceiling == ceiling)
        .findFirst()
        .orElseThrow();
  }
}
