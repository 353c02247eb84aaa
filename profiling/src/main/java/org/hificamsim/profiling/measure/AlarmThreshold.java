package org.hificamsim.profiling.measure;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.data.CsvReader;
import org.hificamsim.profiling.dataset.TableLayout;

/**
 * The least confidence that counts as a detection, chosen to bound the rate of false alarms: a row
 * of {@code thresholds.csv}.
 *
 * @param threshold halfway between the highest confidence that must not count and the next
 *     confidence of a photo with the object
 * @param falseAlarms the share of the photos without the object that reach the threshold
 * @param recall the share of the photos with the object that reach the threshold
 */
public record AlarmThreshold(String detector, double threshold, double falseAlarms, double recall) {
  /** The table's file name. */
  static final String FILE = "thresholds.csv";

  private static final TableLayout<AlarmThreshold> LAYOUT =
      new TableLayout<AlarmThreshold>()
          .with("detector", AlarmThreshold::detector)
          .with("threshold", AlarmThreshold::threshold)
          .with("false_alarms", AlarmThreshold::falseAlarms)
          .with("recall", AlarmThreshold::recall);

  /**
   * Chooses the threshold.
   *
   * @param without the confidences in photos without the object, at least one
   * @param with the confidences in photos with the object
   * @param rate the highest rate of false alarms that is allowed, [0, 1)
   */
  static AlarmThreshold of(String detector, List<Double> without, List<Double> with, double rate) {
    double[] sorted = without.stream().mapToDouble(confidence -> confidence).sorted().toArray();
    double highest = sorted[sorted.length - 1 - (int) (rate * sorted.length)];
    double next =
        with.stream()
            .mapToDouble(confidence -> confidence)
            .filter(confidence -> confidence > highest)
            .min()
            .orElse(Double.NaN);
    double threshold = Double.isNaN(next) ? Math.nextUp(highest) : (highest + next) / 2;
    return new AlarmThreshold(
        detector,
        threshold,
        Arrays.stream(sorted).filter(confidence -> confidence >= threshold).count()
            / (double) sorted.length,
        with.stream().filter(confidence -> confidence >= threshold).count() / (double) with.size());
  }

  static void write(OutputFolder folder, List<AlarmThreshold> thresholds) throws IOException {
    folder.write(FILE, LAYOUT.csv(thresholds));
  }

  /** Reads thresholds by detector; empty if the folder has no such table. */
  public static Map<String, Double> read(Path folder) {
    Path file = folder.resolve(FILE);
    Map<String, Double> thresholds = new LinkedHashMap<>();
    if (Files.exists(file)) {
      CsvReader.open(file, "a table of thresholds")
          .readAll(LAYOUT.names())
          .rows()
          .forEach(
              row ->
                  thresholds.put(
                      row.text("detector"), MeasurementsFile.confidence(row, "threshold")));
    }
    return thresholds;
  }
}
