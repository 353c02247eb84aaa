package org.hificamsim.profiling.dataset;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.detection.Condition;
import org.hificamsim.profiling.dataset.CsvRows.Cell;

/** What else a confidence may depend on: optional columns of a data set and its measurements. */
public enum Covariate {
  /** How much of the object's close-up is unlike its surroundings, [0, 1]; measured. */
  DISTINCTIVENESS(0, 1, "a share from 0 to 1"),
  /** The lens's f-number N. */
  APERTURE(Condition.APERTURE),
  /** k of the lens: a point at radius r (1 in the corners) shows what belongs at r (1 + k r^2). */
  DISTORTION(Condition.DISTORTION),
  /** How bright the scene is, in any unit that is the same for all photos. */
  LIGHT(Condition.LIGHT);

  private final double least;
  private final double most;
  private final String expected;
  private final Optional<Condition> condition;

  Covariate(double least, double most, String expected) {
    this.least = least;
    this.most = most;
    this.expected = expected;
    this.condition = Optional.empty();
  }

  Covariate(Condition condition) {
    this.least = condition.least();
    this.most = condition.most();
    this.expected = condition.expected();
    this.condition = Optional.of(condition);
  }

  /** Its column's name. */
  public String column() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** What a scenario calls it; empty where no scenario says it. */
  public Optional<Condition> condition() {
    return condition;
  }

  /** Those that a photo comes with; the rest is measured. */
  public static List<Covariate> given() {
    return List.of(APERTURE, DISTORTION, LIGHT);
  }

  /** Those that a row of a table says of its photo. */
  public static Map<Covariate, Double> given(Map<String, Cell> row) {
    Map<Covariate, Double> values = new EnumMap<>(Covariate.class);
    for (Covariate covariate : given()) {
      Cell cell = row.get(covariate.column());
      if (cell != null && !cell.text().isEmpty()) {
        values.put(covariate, covariate.read(cell));
      }
    }
    return values;
  }

  /** Whether a column of this name is one of these. */
  public static boolean isColumn(String name) {
    return Arrays.stream(values()).anyMatch(covariate -> covariate.column().equals(name));
  }

  /** The value of a cell that is not empty. */
  public double read(Cell cell) {
    return cell.number(column(), least, most, expected);
  }
}
