package org.hificamsim.parquet;

import java.util.HashMap;
import java.util.Map;
import org.apache.parquet.column.ColumnWriter;
import org.apache.parquet.io.api.Binary;
import org.hificamsim.runs.output.Column;

/** The cells of a column that have been gathered, each kind in an array of its own. */
abstract class ColumnCells {
  private final Column<?> column;

  private ColumnCells(Column<?> column) {
    this.column = column;
  }

  /** No cells yet. */
  static ColumnCells of(Column<?> column) {
    return switch (column.kind()) {
      case INT -> new Ints(column);
      case LONG -> new Longs(column);
      case DOUBLE -> new Doubles(column);
      case TEXT -> new Texts(column);
    };
  }

  void add(int row, long number) {
    throw another("whole number");
  }

  void add(int row, double number) {
    throw another("floating number");
  }

  void add(int row, String text) {
    throw another("text");
  }

  /** Writes the first cells. */
  abstract void write(ColumnWriter out, int rows);

  private IllegalStateException another(String kind) {
    return new IllegalStateException(
        column.name() + " is " + column.kind() + ", but a cell is a " + kind);
  }

  private static final class Ints extends ColumnCells {
    private final int[] cells = new int[ParquetRows.BATCH];

    Ints(Column<?> column) {
      super(column);
    }

    @Override
    void add(int row, long number) {
      cells[row] = Math.toIntExact(number);
    }

    @Override
    void write(ColumnWriter out, int rows) {
      for (int row = 0; row < rows; row++) {
        out.write(cells[row], 0, 0);
      }
    }
  }

  private static final class Longs extends ColumnCells {
    private final long[] cells = new long[ParquetRows.BATCH];

    Longs(Column<?> column) {
      super(column);
    }

    @Override
    void add(int row, long number) {
      cells[row] = number;
    }

    @Override
    void write(ColumnWriter out, int rows) {
      for (int row = 0; row < rows; row++) {
        out.write(cells[row], 0, 0);
      }
    }
  }

  /** NaN is null. */
  private static final class Doubles extends ColumnCells {
    private static final int PRESENT = 1; // Parquet's level of definition

    private final double[] cells = new double[ParquetRows.BATCH];

    Doubles(Column<?> column) {
      super(column);
    }

    @Override
    void add(int row, double number) {
      cells[row] = number;
    }

    @Override
    void write(ColumnWriter out, int rows) {
      for (int row = 0; row < rows; row++) {
        if (Double.isNaN(cells[row])) {
          out.writeNull(0, 0);
        } else {
          out.write(cells[row], 0, PRESENT);
        }
      }
    }
  }

  /** Names, which come again in every step. */
  private static final class Texts extends ColumnCells {
    private final Binary[] cells = new Binary[ParquetRows.BATCH];
    private final Map<String, Binary> known = new HashMap<>();

    Texts(Column<?> column) {
      super(column);
    }

    @Override
    void add(int row, String text) {
      cells[row] = known.computeIfAbsent(text, Binary::fromString);
    }

    @Override
    void write(ColumnWriter out, int rows) {
      for (int row = 0; row < rows; row++) {
        out.write(cells[row], 0, 0);
      }
    }
  }
}
