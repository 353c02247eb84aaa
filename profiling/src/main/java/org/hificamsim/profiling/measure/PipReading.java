package org.hificamsim.profiling.measure;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRows;
import org.hificamsim.profiling.dataset.Dataset;

/** Which pixels count as the object's in PIP. */
public enum PipReading {
  /** Those of the mask where there is one, else those of the patch. */
  SILHOUETTE("pip"),
  /** Those of the patch, a rectangle around the object, as in thesis 3.5. */
  RECTANGLE("pip_rectangle");

  private final String column;

  PipReading(String column) {
    this.column = column;
  }

  /** The name of the column in {@code measurements.csv}, which says how it was counted. */
  String column() {
    return column;
  }

  /** The reading behind a table of measurements. */
  static PipReading of(Path file) {
    return table(file).columns().contains(RECTANGLE.column) ? RECTANGLE : SILHOUETTE;
  }

  /**
   * What was counted in a data set that has been measured: where no row has a mask, rectangles
   * whatever was asked for.
   */
  public static PipReading ofDataset(Path folder) {
    Path table = folder.resolve(Dataset.TABLE);
    boolean unmasked = Files.exists(table) && !hasMasks(table);
    return unmasked ? RECTANGLE : of(folder.resolve(MeasurementsFile.NAME));
  }

  private static CsvRows table(Path file) {
    return CsvReader.open(file, "a table of photos").all(List.of());
  }

  private static boolean hasMasks(Path table) {
    return table(table).rows().stream()
        .anyMatch(row -> row.has("mask") && !row.text("mask").isEmpty());
  }
}
