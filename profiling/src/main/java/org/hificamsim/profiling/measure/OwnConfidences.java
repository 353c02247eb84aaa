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
 * image,q,d,z,confidence[,object][,pip]}. Without PIP, the pinhole camera's is taken.
 */
public final class OwnConfidences {
  private static final List<String> COLUMNS = List.of("image", "q", "d", "z", "confidence");

  private OwnConfidences() {}

  /**
   * Reads a table; the detector is named like the file without its ending.
   *
   * @param camera that took the photos
   * @throws InputException with its place, when a cell is missing or out of range
   */
  public static List<Measurement> read(Path file, PhotoCamera camera) {
    CsvRows table = CsvReader.open(file, "a table of confidences").all(COLUMNS);
    if (table.rows().isEmpty()) {
      throw new InputException(file + ":2:1: no rows, expected one for each photo");
    }
    String stem = file.getFileName().toString().replaceFirst("\\.[^.]*$", "");
    String detector = stem.replaceAll("[^A-Za-z0-9_]+", "-");
    return table.rows().stream().map(row -> measurement(row, detector, camera)).toList();
  }

  private static Measurement measurement(CsvRow row, String detector, PhotoCamera camera) {
    double size = MeasurementsFile.metres(row, "q");
    double distance = MeasurementsFile.metres(row, "d");
    double focalLength = MeasurementsFile.metres(row, "z");
    double pinhole = Math.min(1, camera.pinholePip(size, distance, focalLength));
    return new Measurement(
        row.text("image"),
        row.has("object") ? row.text("object") : "object",
        size,
        distance,
        focalLength,
        row.has("pip") ? MeasurementsFile.share(row, "pip") : Math.max(pinhole, Double.MIN_NORMAL),
        Map.of(detector, MeasurementsFile.confidence(row, "confidence")));
  }
}
