package org.hificamsim.parquet;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.List;
import org.hificamsim.runs.output.Column;
import org.hificamsim.runs.output.TableRows;

/** A Parquet file under way: rows are gathered by column, and written some thousand at a time. */
final class ParquetRows implements TableRows {
  /** Rows that are gathered: few enough for a processor's cache. */
  static final int BATCH = 4096;

  private final ColumnCells[] columns;
  private final RowGroups groups;
  private int column;
  private int rows;
  private boolean closed;

  ParquetRows(OutputStream out, List<? extends Column<?>> columns) throws IOException {
    this.columns = columns.stream().map(ColumnCells::of).toArray(ColumnCells[]::new);
    this.groups = new RowGroups(out, columns);
  }

  @Override
  public void add(long number) {
    columns[column++].add(rows, number);
  }

  @Override
  public void add(double number) {
    columns[column++].add(rows, number);
  }

  @Override
  public void add(String text) {
    columns[column++].add(rows, text);
  }

  @Override
  public void end() {
    if (column != columns.length) {
      throw new IllegalStateException(column + " cells, expected " + columns.length);
    }
    column = 0;
    if (++rows == BATCH) {
      write();
    }
  }

  private void write() {
    try {
      groups.write(columns, rows);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    rows = 0;
  }

  /** Writes what is left; after the first call, nothing. */
  @Override
  public void close() throws IOException {
    if (!closed) {
      closed = true;
      try (groups) {
        groups.write(columns, rows);
      }
    }
  }
}
