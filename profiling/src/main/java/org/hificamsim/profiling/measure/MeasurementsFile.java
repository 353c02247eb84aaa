package org.hificamsim.profiling.measure;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRow;
import org.hificamsim.data.CsvRows;

/**
 * The table {@code measurements.csv}: one row per photo, one column of confidences per detector.
 */
public final class MeasurementsFile {
  /** The file's name. */
  public static final String NAME = "measurements.csv";

  private static final Set<String> PIP =
      Arrays.stream(PipReading.values()).map(PipReading::column).collect(Collectors.toSet());

  /** Columns of older tables that are no detector's, and are ignored. */
  private static final Set<String> CONDITIONS =
      Set.of("distinctiveness", "aperture", "distortion", "light");

  private static final double MAX = 1e5;

  private MeasurementsFile() {}

  /** Writes the table whole or not at all. */
  static void write(Path file, MeasurementColumns columns, List<Measurement> rows)
      throws IOException {
    new OutputFile(file).write(columns.layout().csv(rows));
  }

  /**
   * Reads a table.
   *
   * @throws InputException with its place, when a cell is missing or out of range
   */
  public static List<Measurement> read(Path file) {
    PipReading pip = PipReading.of(file);
    CsvRows table =
        CsvReader.open(file, "a table of measurements").all(MeasurementColumns.required(pip));
    List<String> detectors = table.columns().stream().filter(MeasurementsFile::isDetector).toList();
    if (detectors.isEmpty()) {
      throw new InputException(file + ":1:1: no detector's column, expected one such as orb");
    }
    if (table.rows().isEmpty()) {
      throw new InputException(file + ":2:1: no rows, expected one for each photo");
    }
    return table.rows().stream().map(row -> measurement(row, pip.column(), detectors)).toList();
  }

  private static boolean isDetector(String column) {
    return !MeasurementColumns.PHYSICAL.contains(column)
        && !PIP.contains(column)
        && !CONDITIONS.contains(column);
  }

  private static Measurement measurement(CsvRow row, String pip, List<String> detectors) {
    Map<String, Double> confidences = new LinkedHashMap<>();
    for (String detector : detectors) {
      confidences.put(detector, row.number(detector, 0, 1, "a confidence from 0 to 1"));
    }
    return new Measurement(
        row.text("image"),
        row.text("object"),
        length(row, "size_m"),
        length(row, "distance_m"),
        length(row, "focal_length_m"),
        row.number(pip, Double.MIN_NORMAL, 1, "a share above 0, at most 1"),
        confidences);
  }

  private static double length(CsvRow row, String column) {
    return row.number(column, Double.MIN_NORMAL, MAX, "metres above 0");
  }
}
