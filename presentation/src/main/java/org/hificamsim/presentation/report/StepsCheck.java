package org.hificamsim.presentation.report;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.presentation.replay.Frame;
import org.hificamsim.presentation.replay.Recording;

/** Compares {@code steps.csv} with recorded frames: a page must show the numbers of the table. */
final class StepsCheck {
  private final Path file;
  private final Map<String, String> expected = new HashMap<>();
  private long performance;

  StepsCheck(Path file) {
    this.file = file;
  }

  /** Adds the frames of a run. */
  void expect(Recording recording) {
    for (Frame frame : recording.frames()) {
      StepCoverage coverage = frame.measure();
      expected.put(
          recording.run() + "," + frame.step() + ",",
          IntStream.of(
                  coverage.kMin(),
                  coverage.targets(),
                  coverage.covered0(),
                  coverage.covered1(),
                  coverage.coveredK())
              .mapToObj(Integer::toString)
              .collect(Collectors.joining(",", "", "," + coverage.meanK())));
    }
  }

  /**
   * Reads the table.
   *
   * @throws InputException when it is missing, lacks a row or has another number in one
   */
  void read() throws IOException {
    ReportFiles.require(file);
    try (BufferedReader reader = Files.newBufferedReader(file)) {
      String line = reader.readLine();
      for (int number = 2; (line = reader.readLine()) != null; number++) {
        check(line, number);
      }
    }
    if (!expected.isEmpty()) {
      String[] missing = expected.keySet().stream().sorted().findFirst().orElseThrow().split(",");
      throw new InputException(
          "%s: no row for run %s and step %s, expected the file of the run that was recorded"
              .formatted(file, missing[0], missing[1]));
    }
  }

  private void check(String line, int number) {
    int step = line.indexOf(',', line.indexOf(',') + 1) + 1;
    String wanted = expected.remove(line.substring(0, step));
    if (wanted != null && !line.substring(step).equals(wanted)) {
      throw new InputException(
          "%s:%d:%d: '%s', but the recorded run has %s there, expected the files of one run"
              .formatted(file, number, step + 1, line.substring(step), wanted));
    }
    performance += kMin(line.substring(step).split(",", 2)[0], number, step + 1);
  }

  private long kMin(String text, int line, int column) {
    try {
      return Long.parseLong(text);
    } catch (NumberFormatException e) {
      throw new InputException(
          "%s:%d:%d: k_min is '%s', expected a whole number".formatted(file, line, column, text),
          e);
    }
  }

  /** The sum of k_min over all rows that were read. */
  long performance() {
    return performance;
  }
}
