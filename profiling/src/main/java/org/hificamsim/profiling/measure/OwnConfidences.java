package org.hificamsim.profiling.measure;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRow;
import org.hificamsim.data.CsvRows;
import org.hificamsim.profiling.dataset.PhotoCamera;

/**
 * Confidences of any detector, which a user has measured: a table {@code
 * image,q,d,z,confidence[,object][,pip]}, Without PIP, the pinhole camera's is taken.
 */
public final class OwnConfidences {
  private static final List<String> COLUMNS = List.of("image", "q", "d", "z", "confidence");
  private static final double MAX = 1e5;

  private OwnConfidences() {}

  /**
   * Reads a table; the detector is named like the file.
   *
   * @param camera that took the photos
   * @throws InputException with its place, when a cell is missing or out of range
   */
  public static List<Measurement> read(Path file, PhotoCamera camera) {
    CsvRows table = CsvReader.open(file, "a table of confidences").all(COLUMNS);
    if (table.rows().isEmpty()) {
      throw new InputException(file + ":2:1: no rows, expected one for each photo");
    }
    String detector = detector(file);
    return table.rows().stream().map(row -> measurement(row, detector, camera)).toList();
  }

  /** The name of a table's detector: the file's without its ending. */
  static String detector(Path file) {
    String stem = file.getFileName().toString().replaceFirst("\\.[^.]*$", "");
    return stem.replaceAll("[^A-Za-z0-9_]+", "-");
  }

  private static Measurement measurement(CsvRow row, String detector, PhotoCamera camera) {
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
        row.has("pip")
            ? row.number("pip", Double.MIN_NORMAL, 1, "a share above 0, at most 1")
            : Math.max(pinhole, Double.MIN_NORMAL),
        Map.of(detector, row.number("confidence", 0, 1, "a confidence from 0 to 1")));
  }

  private static double metres(CsvRow row, String column) {
    return row.number(column, Double.MIN_NORMAL, MAX, "metres above 0");
  }
}
