package org.hificamsim.profiling.measure;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRow;
import org.hificamsim.data.CsvRows;
import org.hificamsim.profiling.dataset.PhotoCamera;
import org.hificamsim.profiling.dataset.TableLayout;

/**
 * The table {@code measurements.csv}: one row per photo, one column of confidences per detector.
 */
public final class MeasurementsFile {
  /** The file's name. */
  public static final String NAME = "measurements.csv";

  private static final List<String> PHYSICAL_COLUMNS =
      List.of("image", "object", "size_m", "distance_m", "focal_length_m");

  /** Columns of older tables that do not belong to a detector and are ignored. */
  private static final Set<String> IGNORED_COLUMNS =
      Set.of("distinctiveness", "aperture", "distortion", "light");

  private static final List<String> USER_COLUMNS = List.of("image", "q", "d", "z", "confidence");

  private static final double MAX_METRES = 1e5;

  private MeasurementsFile() {}

  /** Returns the columns of a table, the detectors' last. */
  static TableLayout<Measurement> layout(PipReading pip, Iterable<String> detectors) {
    TableLayout<Measurement> layout =
        new TableLayout<Measurement>()
            .with("image", row -> TableLayout.quoted(row.image()))
            .with("object", row -> TableLayout.quoted(row.object()))
            .with("size_m", Measurement::size)
            .with("distance_m", Measurement::distance)
            .with("focal_length_m", Measurement::focalLength)
            .with(pip.column(), Measurement::pip);
    detectors.forEach(detector -> layout.with(detector, row -> row.confidence(detector)));
    return layout;
  }

  /** Adds the table to a folder's files. */
  static void write(OutputFolder folder, PipReading pip, List<Measurement> rows)
      throws IOException {
    folder.write(NAME, layout(pip, rows.get(0).confidences().keySet()).csv(rows));
  }

  /**
   * Reads a table.
   *
   * @throws InputException with line and column, when a cell is missing or out of range
   */
  public static List<Measurement> read(Path file) {
    String pip = PipReading.of(file).column();
    List<String> required = Stream.concat(PHYSICAL_COLUMNS.stream(), Stream.of(pip)).toList();
    CsvRows table = rows(file, "a table of measurements", required);
    List<String> detectors = table.columns().stream().filter(MeasurementsFile::isDetector).toList();
    if (detectors.isEmpty()) {
      throw new InputException(file + ":1:1: no detector's column, expected one such as orb");
    }
    return table.rows().stream().map(row -> measurement(row, pip, detectors)).toList();
  }

  private static boolean isDetector(String column) {
    return !PHYSICAL_COLUMNS.contains(column)
        && !IGNORED_COLUMNS.contains(column)
        && Arrays.stream(PipReading.values()).noneMatch(pip -> pip.column().equals(column));
  }

  private static Measurement measurement(CsvRow row, String pip, List<String> detectors) {
    Map<String, Double> confidences = new LinkedHashMap<>();
    for (String detector : detectors) {
      confidences.put(detector, confidence(row, detector));
    }
    return new Measurement(
        row.text("image"),
        row.text("object"),
        metres(row, "size_m"),
        metres(row, "distance_m"),
        metres(row, "focal_length_m"),
        share(row, pip),
        confidences);
  }

  /**
   * Reads confidences that users have measured with their own detector, from a table {@code
   * image,q,d,z,confidence[,object][,pip]}. Without a column of PIP, that of a pinhole camera is
   * used. The detector has the name of the file without its ending.
   *
   * @param camera the camera that took the photos
   * @throws InputException with line and column, when a cell is missing or out of range
   */
  public static List<Measurement> readUserTable(Path file, PhotoCamera camera) {
    CsvRows table = rows(file, "a table of confidences", USER_COLUMNS);
    String stem = file.getFileName().toString().replaceFirst("\\.[^.]*$", "");
    String detector = stem.replaceAll("[^A-Za-z0-9_]+", "-");
    return table.rows().stream().map(row -> userMeasurement(row, detector, camera)).toList();
  }

  private static Measurement userMeasurement(CsvRow row, String detector, PhotoCamera camera) {
    double size = metres(row, "q");
    double distance = metres(row, "d");
    double focalLength = metres(row, "z");
    double pinhole = Math.min(1, camera.pinholePip(size, distance, focalLength));
    return new Measurement(
        row.text("image"),
        row.has("object") ? row.text("object") : "object",
        size,
        distance,
        focalLength,
        row.has("pip") ? share(row, "pip") : Math.max(pinhole, Double.MIN_NORMAL),
        Map.of(detector, confidence(row, "confidence")));
  }

  private static CsvRows rows(Path file, String what, List<String> columns) {
    CsvRows table = CsvReader.open(file, what).readAll(columns);
    if (table.rows().isEmpty()) {
      throw new InputException(file + ":2:1: no rows, expected one for each photo");
    }
    return table;
  }

  static double metres(CsvRow row, String column) {
    return row.number(column, Double.MIN_NORMAL, MAX_METRES, "metres above 0");
  }

  static double share(CsvRow row, String column) {
    return row.number(column, Double.MIN_NORMAL, 1, "a share above 0, at most 1");
  }

  static double confidence(CsvRow row, String column) {
    return row.number(column, 0, 1, "a confidence from 0 to 1");
  }
}
