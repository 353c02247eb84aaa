package org.hificamsim.profiling.check;

import java.nio.file.Path;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.TextLines;
import org.hificamsim.tracks.format.MotFile;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.MatrixFile;

/** A calibrated camera and the size of its picture, pixels. */
record CalibratedPicture(Calibration camera, Size size) {
  /**
   * Reads a calibration: XML by Tsai's method, as the PETS recordings have it, or a matrix of three
   * rows and four columns.
   *
   * @param unit of the calibration's world; where nobody says, millimetres for XML and metres for a
   *     matrix
   * @param said the picture's size that somebody says, which a matrix does not
   * @throws InputException with its place, when something is wrong or missing
   */
  static CalibratedPicture read(Path file, Optional<Unit> unit, Optional<Size> said) {
    return isXml(file)
        ? new TsaiFile().read(file, unit.orElse(Unit.MM).metres(), said)
        : matrix(file, unit.orElse(Unit.M).metres(), said);
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

  private static CalibratedPicture matrix(Path file, double metres, Optional<Size> said) {
    double[] rows = MatrixFile.read(file, 3, 4, "three rows of four numbers");
    Calibration camera;
    try {
      camera = new ProjectionMatrix(rows, metres);
    } catch (InputException e) {
      throw new InputException(file + ": " + e.getMessage(), e);
    }
    return new CalibratedPicture(
        camera,
        said.orElseThrow(
            () ->
                InputException.of(
                    "%s: a matrix does not say how large the picture is, expected --image"
                        + " WIDTHxHEIGHT",
                    file)));
  }

  /** Whether the picture's border may have cut a box off. */
  boolean cuts(MotFile.Row box) {
    return box.left() <= 0
        || box.top() <= 0
        || box.left() + box.width() >= size.width()
        || box.top() + box.height() >= size.height();
  }
}
