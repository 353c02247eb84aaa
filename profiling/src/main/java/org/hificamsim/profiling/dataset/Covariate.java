package org.hificamsim.profiling.dataset;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.hificamsim.profiling.dataset.CsvRows.Cell;

/** What else a confidence may depend on: optional columns of a data set and its measurements. */
public enum Covariate {
  /** How much of the object's close-up is unlike its surroundings, [0, 1]; measured. */
  DISTINCTIVENESS(0, 1, "a share from 0 to 1"),
  /** The lens's f-number N. */
  APERTURE(0, 1000, "an f-number from 0 to 1000"),
  /** k of the lens: a point at radius r (1 in the corners) shows what belongs at r (1 + k r^2). */
  DISTORTION(-1, 1, "k of radial distortion, from -1 to 1"),
  /** How bright the scene is, in any unit that is the same for all photos. */
  LIGHT(Double.MIN_NORMAL, 1e9, "a brightness above 0");

  private final double least;
  private final double most;
  private final String expected;

  Covariate(double least, double most, String expected) {
    this.least = least;
    this.most = most;
    this.expected = expected;
  }

  /** Its column's name. */
  public String column() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Those that a photo comes with; the rest is measured. */
  public static List<Covariate> given() {
    return List.of(APERTURE, DISTORTION, LIGHT);
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
