package org.hificamsim.runs.output;

import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
import org.hificamsim.core.InputException;

/**
 * A row of {@code steps.csv} as it was read, or of the same table in another format.
 *
 * @param line in the file, from 1
 * @param measures the other columns
 */
public record StepRow(Path file, int line, String run, String step, String measures) {
  /**
   * Reads the table of a run's folder, row by row.
   *
   * @return the file
   * @throws InputException when it is missing or a row is too short
   */
  public static Path each(Path folder, Consumer<StepRow> taker) throws IOException {
    TableFormat format = TableFormats.of(folder, RunTables.STEPS);
    Path file = new ResultFolder(folder).file(RunTables.STEPS.file(format.name()));
    int[] line = {1};
    format.each(file, row -> taker.accept(of(file, ++line[0], row)));
    return file;
  }

  private static StepRow of(Path file, int number, String line) {
    String[] cells = line.split(",", 3);
    if (cells.length < 3) {
      throw InputException.of(
          "%s:%s:1: '%s' is no row, expected run,step,k_min,...", file, number, line);
    }
    return new StepRow(file, number, cells[0], cells[1], cells[2]);
  }

  /**
   * The step.
   *
   * @throws InputException when it is none below {@code steps}
   */
  public int step(int steps) {
    long number = number("step", step, run.length() + 2);
    if (number < 0 || number >= steps) {
      throw error(run.length() + 2, "step is " + step + ", expected one below " + steps);
    }
    return (int) number;
  }

  /**
   * The k_min.
   *
   * @throws InputException when it is no number
   */
  public long kMin() {
    return number("k_min", measures.split(",", 2)[0], measured());
  }

  /**
   * The score, the last column.
   *
   * @throws InputException when it is no number
   */
  public double score() {
    String cell = measures.substring(measures.lastIndexOf(',') + 1);
    try {
      return Double.parseDouble(cell);
    } catch (NumberFormatException e) {
      int column = measured() + measures.length() - cell.length();
      throw error(column, "score is '" + cell + "', expected a number");
    }
  }

  private int measured() {
    return run.length() + step.length() + 3;
  }

  private long number(String name, String cell, int column) {
    try {
      return Long.parseLong(cell);
    } catch (NumberFormatException e) {
      throw error(column, name + " is '" + cell + "', expected a whole number");
    }
  }

  private InputException error(int column, String message) {
    return new InputException(file + ":" + line + ":" + column + ": " + message);
  }
}
