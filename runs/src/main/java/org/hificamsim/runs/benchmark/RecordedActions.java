package org.hificamsim.runs.benchmark;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.CsvTable;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Rows;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRow;

/**
 * The file of actions of a task's testing episodes: a row for each episode and step with the index
 * of the view that each camera had chosen last.
 */
final class RecordedActions {
  private static final String SEED = "seed";
  private static final String STEP = "step";
  private static final String VIEW = "the number of a view";

  private RecordedActions() {}

  /** The name of a task's file in the folder of an entry. */
  static String file(String task) {
    return task + ".csv.gz";
  }

  private static List<String> columns(Benchmark benchmark, String task) {
    Stream<String> cameras = benchmark.site(task).everyCamera().map(CameraSpec::name);
    return Stream.concat(Stream.of(SEED, STEP), cameras).toList();
  }

  static void write(OutputFolder folder, String task, Benchmark benchmark, List<Episode> episodes)
      throws IOException {
    String columns = String.join(",", columns(benchmark, task));
    try (Rows out = new CsvTable(folder.open(file(task)), columns, ',', "\n")) {
      for (int i = 0; i < episodes.size(); i++) {
        int[][] views = episodes.get(i).views();
        for (int step = 0; step < views.length; step++) {
          out.add(BenchmarkTask.TESTING.get(i));
          out.add(step);
          for (int view : views[step]) {
            out.add(view);
          }
          out.end();
        }
      }
    }
  }

  /**
   * Reads the episodes of a task.
   *
   * @return the views, by episode and step
   * @throws InputException when an episode is missing, or a row is out of place
   */
  static List<int[][]> read(Path file, String task, Benchmark benchmark) {
    List<String> columns = columns(benchmark, task);
    int steps = benchmark.task(task).steps();
    List<int[][]> episodes = new ArrayList<>();
    try (CsvReader reader = CsvReader.openCommaSeparated(file, "actions of 'benchmark run'")) {
      if (!reader.header(columns).equals(columns)) {
        throw InputException.of("%s: other columns, expected %s", file, String.join(",", columns));
      }
      for (long seed : BenchmarkTask.TESTING) {
        int[][] views = new int[steps][];
        for (int step = 0; step < steps; step++) {
          views[step] = views(reader.next(), columns, seed, step, file);
        }
        episodes.add(views);
      }
      if (reader.next() != null) {
        throw InputException.of("%s: more rows, expected %s steps an episode", file, steps);
      }
    }
    return episodes;
  }

  private static int[] views(CsvRow row, List<String> columns, long seed, int step, Path file) {
    if (row == null || integer(row, SEED) != seed || integer(row, STEP) != step) {
      throw InputException.of("%s: no step %s of seed %s, expected every one", file, step, seed);
    }
    return columns.stream().skip(2).mapToInt(camera -> (int) integer(row, camera)).toArray();
  }

  private static long integer(CsvRow row, String column) {
    double number = row.number(column, Integer.MIN_VALUE, Integer.MAX_VALUE, VIEW);
    if (number != Math.rint(number)) {
      throw row.invalid(column, VIEW);
    }
    return (long) number;
  }
}
