package org.hificamsim.placement.site;

import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.hificamsim.core.file.Fields;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.data.CsvRow;

/**
 * The settings of a lens: a single one, some steps, or the ends of a range, of which a plan tries a
 * few settings.
 *
 * @param values angles of view in degrees, or focal lengths in millimetres
 */
record LensSteps(List<Double> values, boolean isRange) {
  /** The number of settings of a range that are tried. */
  private static final int STEPS = 4;

  /**
   * Reads a cell of a table such as {@code 95}, {@code 33-105} or {@code 30 60 90}.
   *
   * @param unit the unit for the message about a wrong cell
   */
  static LensSteps read(CsvRow row, String column, String unit, double least, double greatest) {
    String text = row.text(column).strip();
    boolean isRange = text.matches("[^-–]+[-–][^-–]+");
    double[] values =
        Arrays.stream(text.split(isRange ? "[-–]" : "[\\s/]+"))
            .map(String::strip)
            .mapToDouble(Fields::value)
            .sorted()
            .toArray();
    if (!Arrays.stream(values).allMatch(value -> value >= least && value <= greatest)) {
      throw row.invalid(
          column,
          "%s from %s to %s: one, a range as 33-105, or steps as 30 60 90"
              .formatted(unit, least, greatest));
    }
    return new LensSteps(Arrays.stream(values).distinct().boxed().toList(), isRange);
  }

  /** Returns the angles of view of focal lengths on a sensor of this width, both in millimetres. */
  LensSteps onSensor(double width) {
    List<Double> angles =
        values.stream().map(focal -> OpticsSpec.angleOfView(width, focal)).sorted().toList();
    return new LensSteps(angles, isRange);
  }

  /** Returns all angles of view that are tried, rising, rounded to a tenth of a degree. */
  List<Double> angles() {
    double narrowest = values.get(0);
    double widest = values.get(values.size() - 1);
    DoubleStream all =
        isRange && widest > narrowest
            ? IntStream.range(0, STEPS)
                .mapToDouble(step -> step / (STEPS - 1.0))
                .map(part -> narrowest * Math.pow(widest / narrowest, part))
            : values.stream().mapToDouble(angle -> angle);
    return all.map(angle -> Math.rint(10 * angle) / 10).boxed().toList();
  }
}
