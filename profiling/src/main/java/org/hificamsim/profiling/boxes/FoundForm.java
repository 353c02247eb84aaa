package org.hificamsim.profiling.boxes;

/** What the probability that a person is found depends on, the simplest first. */
enum FoundForm {
  /** Nothing. */
  CONSTANT(false, false, false, false),
  /** The height alone. */
  HEIGHT(true, false, false, false),
  /** The hidden share alone. */
  HIDDEN(false, true, false, false),
  /** Both. */
  BOTH(true, true, false, false),
  /** Both, and the largest boxes are not always found. */
  BOTH_WITH_CEILING(true, true, false, true),
  /** Both, and the smallest boxes are sometimes found. */
  BOTH_WITH_FLOOR(true, true, true, false),
  /** Both, between a floor and a ceiling. */
  BOTH_WITH_LIMITS(true, true, true, true);

  private final boolean height;
  private final boolean hidden;
  private final boolean floor;
  private final boolean ceiling;

  FoundForm(boolean height, boolean hidden, boolean floor, boolean ceiling) {
    this.height = height;
    this.hidden = hidden;
    this.floor = floor;
    this.ceiling = ceiling;
  }

  boolean hasHeight() {
    return height;
  }

  boolean hasHidden() {
    return hidden;
  }

  boolean hasFloor() {
    return floor;
  }

  boolean hasCeiling() {
    return ceiling;
  }

  /** Whether a model may have this form. */
  boolean isModel() {
    return height && hidden;
  }
}
