package org.hificamsim.tracks.ground;

import java.nio.file.Path;
import org.hificamsim.core.file.TextLines;

/** Reads a matrix: rows of numbers separated by spaces; lines that begin with # are comments. */
public final class MatrixFile {
  private MatrixFile() {}

  /**
   * Returns the matrix, row by row.
   *
   * @param expected the rows and columns in words
   * @throws org.hificamsim.core.InputException with the place, if the file has anything else
   */
  public static double[] read(Path file, int rows, int columns, String expected) {
    double[] matrix = new double[rows * columns];
    int count = 0;
    try (TextLines lines = TextLines.open(file)) {
      while (lines.nextFields()) {
        if (lines.count() != columns || count == matrix.length) {
          throw lines
              .place(0)
              .error("a row of %s fields, expected %s".formatted(lines.count(), expected));
        }
        for (int column = 0; column < columns; column++) {
          matrix[count++] = lines.number(column, "number");
        }
      }
      if (count < matrix.length) {
        throw lines.place().error("the matrix ends, expected " + expected);
      }
    }
    return matrix;
  }
}
