package org.hificamsim.profiling.check;

import java.nio.file.Path;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.Fields;
import org.hificamsim.core.file.TextLines;

/** Reads three rows of four numbers between blanks; lines that begin with # say nothing. */
final class MatrixFile {
  private static final int ROWS = 3;
  private static final int COLUMNS = 4;
  private static final String EXPECTED = "three rows of four numbers";

  private MatrixFile() {}

  /**
   * The camera.
   *
   * @param metres of a unit of its world
   * @throws InputException with its place, when it is anything else
   */
  static ProjectionMatrix read(Path file, double metres) {
    double[] matrix = new double[ROWS * COLUMNS];
    int count = 0;
    try (TextLines lines = TextLines.open(file)) {
      while (lines.nextFields()) {
        count = row(lines, matrix, count);
      }
      if (count < matrix.length) {
        throw lines.place().error("the matrix ends, expected " + EXPECTED);
      }
    }
    return camera(file, matrix, metres);
  }

  private static int row(Fields fields, double[] matrix, int from) {
    if (fields.count() != COLUMNS || from == matrix.length) {
      throw fields
          .place(0)
          .error("a row of %s fields, expected %s".formatted(fields.count(), EXPECTED));
    }
    for (int i = 0; i < COLUMNS; i++) {
      matrix[from + i] = fields.number(i, "number");
    }
    return from + COLUMNS;
  }

  private static ProjectionMatrix camera(Path file, double[] matrix, double metres) {
    try {
      return new ProjectionMatrix(matrix, metres);
    } catch (InputException e) {
      throw new InputException(file + ": " + e.getMessage(), e);
    }
  }
}
