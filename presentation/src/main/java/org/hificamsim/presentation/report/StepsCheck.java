package org.hificamsim.presentation.report;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.CsvTable;
import org.hificamsim.presentation.replay.Frame;
import org.hificamsim.presentation.replay.RecordedRun;
import org.hificamsim.runs.output.RunTables;
import org.hificamsim.runs.output.StepCursor;
import org.hificamsim.runs.output.StepRow;

/** Compares {@code steps.csv} with recorded frames: a page must show the numbers of the table. */
final class StepsCheck {
  private final Map<String, String> expected = new HashMap<>();
  private long performance;

  /** Adds the frames of a run. */
  void expect(RecordedRun recording) throws IOException {
    StringWriter text = new StringWriter();
    StepCursor at = new StepCursor();
    try (CsvTable row = new CsvTable(text, "", ',', "")) {
      for (Frame frame : recording.frames()) {
        at.at(recording.run(), frame.step(), frame.measure());
        RunTables.steps(frame.measure().byChance()).add(at, row);
        String which = recording.run() + "," + frame.step();
        expected.put(which, text.toString().substring(which.length() + 1));
        text.getBuffer().setLength(0);
      }
    }
  }

  /**
   * Reads the table of a folder.
   *
   * @return its file
   * @throws InputException when it is missing, lacks a row or has another number in one
   */
  Path read(Path folder) throws IOException {
    Path file = StepRow.each(folder, this::check);
    if (!expected.isEmpty()) {
      String[] missing = expected.keySet().stream().sorted().findFirst().orElseThrow().split(",");
      throw new InputException(
          "%s: no row for run %s and step %s, expected the file of the run that was recorded"
              .formatted(file, missing[0], missing[1]));
    }
    return file;
  }

  private void check(StepRow row) {
    String wanted = expected.remove(row.run() + "," + row.step());
    if (wanted != null && !(row.measures() + ",").startsWith(wanted + ",")) {
      throw row.error(
          "'%s', but the recorded run has %s there, expected the files of one run"
              .formatted(row.measures(), wanted));
    }
    performance += row.kMin();
  }

  /** The sum of k_min over all rows that were read. */
  long performance() {
    return performance;
  }
}
