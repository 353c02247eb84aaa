package org.hificamsim.profiling.check;

import java.nio.file.Path;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.TextLines;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.MatrixFile;

/**
 * Reads a calibration: XML by Tsai's method, as the PETS recordings have it, or a matrix of three
 * rows and four columns.
 */
final class CalibrationFile {
  private CalibrationFile() {}

  /**
   * The camera and its picture.
   *
   * @param unit of the calibration's world; where nobody says, millimetres for XML and metres for a
   *     matrix
   * @param image the size that somebody says, which a matrix does not
   * @throws InputException with its place, when something is wrong or missing
   */
  static CalibratedPicture read(Path file, Optional<Unit> unit, Optional<ImageSize> image) {
    return isXml(file)
        ? new TsaiFile(unit.orElse(Unit.MM)).read(file, image)
        : matrix(file, unit.orElse(Unit.M), image);
  }

  private static boolean isXml(Path file) {
    try (TextLines lines = TextLines.open(file)) {
      while (lines.next()) {
        if (!lines.text().isBlank()) {
          return lines.text().strip().replace("\uFEFF", "").startsWith("<");
        }
      }
      return false;
    }
  }

  private static CalibratedPicture matrix(Path file, Unit unit, Optional<ImageSize> image) {
    double[] rows = MatrixFile.read(file, 3, 4, "three rows of four numbers");
    ProjectionMatrix camera = camera(file, rows, unit.metres());
    ImageSize size =
        image.orElseThrow(
            () ->
                new InputException(
                    file
                        + ": a matrix does not say how large the picture is, expected --image"
                        + " WIDTHxHEIGHT"));
    return new CalibratedPicture(camera, size.width(), size.height());
  }

  private static ProjectionMatrix camera(Path file, double[] rows, double metres) {
    try {
      return new ProjectionMatrix(rows, metres);
    } catch (InputException e) {
      throw new InputException(file + ": " + e.getMessage(), e);
    }
  }
}
