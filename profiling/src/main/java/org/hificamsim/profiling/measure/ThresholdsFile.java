package org.hificamsim.profiling.measure;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.data.CsvReader;
import org.hificamsim.profiling.dataset.TableLayout;

/** The table {@code thresholds.csv}: from which confidence on each detector detects. */
public final class ThresholdsFile {
  /** The file's name. */
  public static final String NAME = "thresholds.csv";

  private static final TableLayout<Map.Entry<String, AlarmThreshold>> LAYOUT =
      new TableLayout<Map.Entry<String, AlarmThreshold>>()
          .with("detector", Map.Entry::getKey)
          .with("threshold", row -> row.getValue().threshold())
          .with("false_alarms", row -> row.getValue().falseAlarms())
          .with("recall", row -> row.getValue().recall());

  private ThresholdsFile() {}

  static void write(Path file, Map<String, AlarmThreshold> thresholds) throws IOException {
    new OutputFile(file).write(LAYOUT.csv(List.copyOf(thresholds.entrySet())));
  }

  /** Thresholds by detector; none where a folder has no such table. */
  public static Map<String, Double> read(Path folder) {
    Path file = folder.resolve(NAME);
    Map<String, Double> thresholds = new LinkedHashMap<>();
    if (Files.exists(file)) {
      CsvReader.open(file, "a table of thresholds")
          .all(LAYOUT.names())
          .rows()
          .forEach(
              row ->
                  thresholds.put(
                      row.text("detector"),
                      row.number("threshold", 0, 1, "a confidence from 0 to 1")));
    }
    return thresholds;
  }
}
