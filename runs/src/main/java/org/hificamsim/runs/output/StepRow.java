package org.hificamsim.runs.output;

import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
import org.hificamsim.core.InputException;

/**
 * The score of a step, from {@code steps.csv} or the same table in another format.
 *
 * @param run the repeat, from 0
 */
public record StepRow(int run, long step, double score) {
  /**
   * Reads the table of a run's folder, row by row.
   *
   * @return the file
   * @throws InputException when it is missing or a row is no such row
   */
  public static Path each(Path folder, Consumer<StepRow> taker) throws IOException {
    TableFormat format = TableFormat.of(folder, RunTables.STEPS);
    Path file = new ResultFolder(folder).file(RunTables.STEPS.file(format.name()));
    int[] line = {1};
    format.each(file, row -> taker.accept(of(file, ++line[0], row)));
    return file;
  }

  /** The score is the last cell. */
  private static StepRow of(Path file, int number, String line) {
    String[] cells = line.split(",", -1);
    try {
      if (cells.length > 2) {
        double score = Double.parseDouble(cells[cells.length - 1]);
        return new StepRow(Integer.parseInt(cells[0]), Long.parseLong(cells[1]), score);
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw InputException.of(
        "%s:%s:1: '%s' is no row, expected run,step,k_min,...,score, numbers", file, number, line);
  }
}
