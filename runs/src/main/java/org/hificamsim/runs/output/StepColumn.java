package org.hificamsim.runs.output;

import java.util.Locale;

/**
 * A column of a table with a row for each step, camera or target of a run: what {@code
 * docs/data.md} says of it, for formats that keep it beside the values.
 */
public enum StepColumn {
  RUN(Kind.INT, "", "the repeat, from 0"),
  STEP(Kind.LONG, "steps", "from 0"),
  K_MIN(Kind.INT, "cameras", "the least number of cameras that cover a target (Eq 7.1)"),
  TARGETS(Kind.INT, "targets", "present"),
  COVERED_0(Kind.INT, "targets", "that no camera covers"),
  COVERED_1(Kind.INT, "targets", "that exactly one camera covers"),
  COVERED_K(Kind.INT, "targets", "that two or more cameras cover"),
  MEAN_K(Kind.DOUBLE, "cameras", "that cover a target, mean; 0 without targets"),
  EXPECTED_K_MIN(Kind.DOUBLE, "cameras", "k_min as it was to be expected before luck was drawn"),
  EXPECTED_COVERED_0(Kind.DOUBLE, "targets", "covered_0, expected"),
  EXPECTED_COVERED_1(Kind.DOUBLE, "targets", "covered_1, expected"),
  EXPECTED_COVERED_K(Kind.DOUBLE, "targets", "covered_k, expected"),
  EXPECTED_MEAN_K(Kind.DOUBLE, "cameras", "mean_k, expected"),
  LEAST_EXPECTED_K(
      Kind.DOUBLE, "cameras", "the least expected number of cameras that cover a target"),
  LEAST_CHANCE(Kind.DOUBLE, "probability", "the least one of a target to be covered"),
  CAMERA(Kind.TEXT, "", "the camera's name"),
  LEVEL(Kind.INT, "", "zoom level, 0 is the narrowest"),
  RADIUS(Kind.DOUBLE, "m", "how far the camera detects at this level"),
  DETECTED(Kind.INT, "targets", "that the camera detects"),
  PAN(Kind.DOUBLE, "degrees", "of the chosen view, off the mounted heading"),
  VIEWING_ANGLE(Kind.DOUBLE, "degrees", "of the chosen view"),
  MOVING(Kind.INT, "", "1 while the camera is on its way to the view, else 0"),
  TARGET(Kind.TEXT, "", "the target's name"),
  X(Kind.DOUBLE, "m", "where the target is"),
  Y(Kind.DOUBLE, "m", "where the target is"),
  K(Kind.INT, "cameras", "that cover the target"),
  CHANCE_1(Kind.DOUBLE, "probability", "that one or more cameras cover the target"),
  CHANCE_K(Kind.DOUBLE, "probability", "that two or more cameras cover the target");

  /** What the cells are. */
  public enum Kind {
    /** Whole numbers of 32 bits. */
    INT,
    /** Whole numbers of 64 bits. */
    LONG,
    /** Floating numbers of 64 bits; NaN is a missing value. */
    DOUBLE,
    /** Texts. */
    TEXT
  }

  private final Kind kind;
  private final String unit;
  private final String meaning;

  StepColumn(Kind kind, String unit, String meaning) {
    this.kind = kind;
    this.unit = unit;
    this.meaning = meaning;
  }

  /** Its name in the table. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** What the cells are. */
  public Kind kind() {
    return kind;
  }

  /** What numbers count or are measured in; empty where there is none. */
  public String unit() {
    return unit;
  }

  /** What it says. */
  public String meaning() {
    return meaning;
  }
}
