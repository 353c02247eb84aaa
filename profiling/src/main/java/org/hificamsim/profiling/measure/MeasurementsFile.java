package org.hificamsim.profiling.measure;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.profiling.dataset.CsvRows;
import org.hificamsim.profiling.dataset.CsvRows.Cell;

/**
 * The table {@code measurements.csv}: one row per photo, one column of confidences per detector.
 */
public final class MeasurementsFile {
  /** The file's name. */
  public static final String NAME = "measurements.csv";

  private static final List<String> PHYSICAL =
      List.of("image", "object", "size_m", "distance_m", "focal_length_m");
  private static final Set<String> PIP =
      Arrays.stream(PipReading.values()).map(PipReading::column).collect(Collectors.toSet());
  private static final double MAX = 1e5;

  private MeasurementsFile() {}

  /** Writes the table whole or not at all. */
  public static void write(Path file, MeasureSettings settings, List<Measurement> rows)
      throws IOException {
    StringBuilder table = new StringBuilder(header(settings));
    rows.forEach(row -> table.append(line(row)));
    new OutputFile(file).write(table.toString());
  }

  /**
   * Reads a table.
   *
   * @throws InputException with its place, when a cell is missing or out of range
   */
  public static List<Measurement> read(Path file) {
    PipReading pip = PipReading.of(file);
    CsvRows table = CsvRows.read(file, fixed(pip));
    List<String> detectors = table.columns().stream().filter(MeasurementsFile::isDetector).toList();
    if (detectors.isEmpty()) {
      throw new InputException(file + ":1:1: no detector's column, expected one such as orb");
    }
    if (table.rows().isEmpty()) {
      throw new InputException(file + ":2:1: no rows, expected one for each photo");
    }
    List<Measurement> rows = new ArrayList<>();
    for (Map<String, Cell> row : table.rows()) {
      rows.add(measurement(row, pip.column(), detectors));
    }
    return rows;
  }

  static String header(MeasureSettings settings) {
    return String.join(",", fixed(settings.pip()))
        + ","
        + String.join(",", settings.detectors())
        + "\n";
  }

  private static List<String> fixed(PipReading pip) {
    return Stream.concat(PHYSICAL.stream(), Stream.of(pip.column())).toList();
  }

  private static boolean isDetector(String column) {
    return !PHYSICAL.contains(column) && !PIP.contains(column);
  }

  static String line(Measurement row) {
    String confidences =
        row.confidences().values().stream().map(String::valueOf).collect(Collectors.joining(","));
    return "%s,%s,%s,%s,%s,%s,%s\n"
        .formatted(
            quoted(row.image()),
            quoted(row.object()),
            row.size(),
            row.distance(),
            row.focalLength(),
            row.pip(),
            confidences);
  }

  private static String quoted(String text) {
    return text.matches("[^,\"\\n\\r]*") ? text : '"' + text.replace("\"", "\"\"") + '"';
  }

  private static Measurement measurement(
      Map<String, Cell> row, String pip, List<String> detectors) {
    Map<String, Double> confidences = new LinkedHashMap<>();
    for (String detector : detectors) {
      confidences.put(
          detector, row.get(detector).number(detector, 0, 1, "a confidence from 0 to 1"));
    }
    return new Measurement(
        row.get("image").text(),
        row.get("object").text(),
        length(row, "size_m"),
        length(row, "distance_m"),
        length(row, "focal_length_m"),
        row.get(pip).number(pip, Double.MIN_NORMAL, 1, "a share above 0, at most 1"),
        confidences);
  }

  private static double length(Map<String, Cell> row, String column) {
    return row.get(column).number(column, Double.MIN_NORMAL, MAX, "metres above 0");
  }
}
