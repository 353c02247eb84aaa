package org.hificamsim.runs.output;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.hificamsim.core.InputException;
import org.hificamsim.core.metrics.StepCoverage;

/**
 * A row of {@code steps.csv} as it was read.
 *
 * @param line in the file, from 1
 */
public record StepRow(Path file, int line, String text) {
  /** What is measured in each step, in the order of columns. */
  public static List<Number> measures(StepCoverage coverage) {
    return List.of(
        coverage.kMin(),
        coverage.targets(),
        coverage.covered0(),
        coverage.covered1(),
        coverage.coveredK(),
        coverage.meanK());
  }

  /**
   * Reads the table of a run's folder, row by row.
   *
   * @throws InputException when it is missing
   */
  public static void each(Path folder, Consumer<StepRow> taker) throws IOException {
    Path file = new ResultFolder(folder).file(Table.RUN_STEPS.file());
    try (BufferedReader reader = Files.newBufferedReader(file)) {
      String line = reader.readLine();
      for (int number = 2; (line = reader.readLine()) != null; number++) {
        taker.accept(new StepRow(file, number, line));
      }
    }
  }

  /** The run and the step, each followed by a comma. */
  public String key() {
    return text.substring(0, measured());
  }

  /** The columns of {@link #measures}. */
  public String measures() {
    return text.substring(measured());
  }

  /**
   * The step.
   *
   * @throws InputException when it is none below {@code steps}
   */
  public int step(int steps) {
    String[] cells = key().split(",", -1);
    long step = cells.length < 2 ? -1 : number("step", cells[1], cells[0].length() + 1);
    if (step < 0 || step >= steps) {
      throw error(0, "'" + text + "' is no row of run,step,k_min,... with a step below " + steps);
    }
    return (int) step;
  }

  /**
   * The k_min.
   *
   * @throws InputException when it is no number
   */
  public long kMin() {
    return number("k_min", measures().split(",", 2)[0], measured());
  }

  /** That what is measured is not what was expected. */
  public InputException error(String message) {
    return error(measured(), message);
  }

  private int measured() {
    return text.indexOf(',', text.indexOf(',') + 1) + 1;
  }

  private long number(String column, String cell, int position) {
    try {
      return Long.parseLong(cell);
    } catch (NumberFormatException e) {
      throw error(position, column + " is '" + cell + "', expected a whole number");
    }
  }

  private InputException error(int position, String message) {
    return new InputException(file + ":" + line + ":" + (position + 1) + ": " + message);
  }
}
