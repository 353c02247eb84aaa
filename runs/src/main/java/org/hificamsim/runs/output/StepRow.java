package org.hificamsim.runs.output;

import static org.hificamsim.core.NamedSetting.setting;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import org.hificamsim.core.InputException;

/**
 * The score of a step: a row of {@code steps.csv}.
 *
 * @param run the repeat, from 0
 */
public record StepRow(int run, long step, double score) {
  private static final int BUFFER = 1 << 16;

  /**
   * Reads the table of a run's folder row by row.
   *
   * @return the file
   * @throws InputException when it is missing, is not CSV or has a row without a score
   */
  public static Path forEachRow(Path folder, Consumer<StepRow> consumer) throws IOException {
    requireCsv(folder);
    Path file = new ResultFolder(folder).file(RunTables.STEPS.file());
    try (InputStream in = Files.newInputStream(file);
        // an InputStreamReader replaces malformed bytes, so that their row is rejected
        BufferedReader reader =
            new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8), BUFFER)) {
      int number = 1;
      reader.readLine();
      for (String line; (line = reader.readLine()) != null; ) {
        number++;
        consumer.accept(parse(file, number, line));
      }
    }
    return file;
  }

  private static void requireCsv(Path folder) {
    for (String format : TableFormat.NAMES) {
      Path file = folder.resolve(RunTables.STEPS.file(format));
      if (!format.equals(TableFormat.CSV.name()) && Files.isRegularFile(file)) {
        throw InputException.of(
            "'%s' is not read here, expected a run with %s",
            file, setting("format", TableFormat.CSV.name()));
      }
    }
  }

  /** Reads a row, the last cell of which is the score. */
  private static StepRow parse(Path file, int number, String line) {
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
