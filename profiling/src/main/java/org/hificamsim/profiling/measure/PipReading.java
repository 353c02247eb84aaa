package org.hificamsim.profiling.measure;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRows;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.LabelledPhoto;
import org.hificamsim.profiling.dataset.PhotoCamera;
import org.hificamsim.profiling.detector.Photograph;
import org.opencv.core.Core;

/** The pixels that count as the object's in PIP. */
public enum PipReading {
  /** The pixels of the mask, or of the patch if there is no mask. */
  SILHOUETTE("pip"),
  /** The pixels of the patch, a rectangle around the object, as in thesis 3.5. */
  RECTANGLE("pip_rectangle");

  private final String column;

  PipReading(String column) {
    this.column = column;
  }

  /** Returns the column in {@code measurements.csv}, whose name says how pixels were counted. */
  String column() {
    return column;
  }

  /** Returns the true PIP: the share of the image that the object fills. */
  double pip(LabelledPhoto photo, PhotoCamera camera) {
    long set =
        this == RECTANGLE || photo.mask().isEmpty()
            ? photo.patch().area()
            : pixels(photo.mask().get());
    return set / (double) camera.pixels();
  }

  private static long pixels(Path mask) {
    try (Photograph picture = new Photograph(mask)) {
      int set = Core.countNonZero(picture.grey());
      if (set == 0) {
        throw new InputException(mask + ": the mask is empty, expected the object's pixels");
      }
      return set;
    }
  }

  /** Returns the reading that a table of measurements was made with. */
  static PipReading of(Path file) {
    return table(file).columns().contains(RECTANGLE.column) ? RECTANGLE : SILHOUETTE;
  }

  /**
   * Returns the reading that a measured data set was made with. Without any mask it is {@link
   * #RECTANGLE}, regardless of the request.
   */
  public static PipReading ofDataset(Path folder) {
    Path photos = folder.resolve(Dataset.TABLE);
    boolean unmasked =
        Files.exists(photos)
            && table(photos).rows().stream()
                .noneMatch(row -> row.has("mask") && !row.text("mask").isEmpty());
    return unmasked ? RECTANGLE : of(folder.resolve(MeasurementsFile.NAME));
  }

  private static CsvRows table(Path file) {
    return CsvReader.open(file, "a table of photos").readAll(List.of());
  }
}
