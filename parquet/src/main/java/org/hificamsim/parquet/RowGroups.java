package org.hificamsim.parquet;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.TreeMap;
import org.apache.parquet.bytes.HeapByteBufferAllocator;
import org.apache.parquet.column.ColumnWriteStore;
import org.apache.parquet.column.ParquetProperties;
import org.apache.parquet.column.ParquetProperties.WriterVersion;
import org.apache.parquet.hadoop.ColumnChunkPageWriteStore;
import org.apache.parquet.hadoop.ParquetFileWriter;
import org.apache.parquet.schema.MessageType;
import org.hificamsim.runs.output.Column;

/**
 * The row groups of a Parquet file. One is in memory at a time, so that memory stays the same
 * however many rows there are.
 */
final class RowGroups implements Closeable {
  /** What readers take at once, or skip. */
  static final int MAX_ROWS = 1 << 20;

  static final long MAX_BYTES = 16 << 20;
  private static final int TEXT = 64; // bytes of one in the statistics

  private final MessageType schema;
  private final ParquetProperties properties;
  private final ParquetFileWriter file;
  private final List<? extends Column<?>> columns;
  private ColumnChunkPageWriteStore pages;
  private ColumnWriteStore cells;
  private int rows;

  RowGroups(OutputStream out, List<? extends Column<?>> columns) throws IOException {
    this.columns = columns;
    schema = Schema.of(columns);
    properties = properties(columns);
    file =
        new ParquetFileWriter(
            new StreamFile(out),
            schema,
            ParquetFileWriter.Mode.CREATE,
            MAX_BYTES,
            0,
            TEXT,
            TEXT,
            true);
    file.start();
    begin();
  }

  /** Steps are written as differences, and all else as the number of a value seen before. */
  private static ParquetProperties properties(List<? extends Column<?>> columns) {
    ParquetProperties.Builder builder =
        ParquetProperties.builder()
            .withWriterVersion(WriterVersion.PARQUET_2_0)
            .withAllocator(new HeapByteBufferAllocator())
            .withPageRowCountLimit(MAX_ROWS);
    columns.stream()
        .filter(column -> column.kind() == Column.Kind.LONG)
        .forEach(column -> builder.withDictionaryEncoding(column.name(), false));
    return builder.build();
  }

  private void begin() {
    pages =
        new ColumnChunkPageWriteStore(new Gzip(), schema, properties.getAllocator(), TEXT, true);
    cells = properties.newColumnWriteStore(schema, pages);
    rows = 0;
  }

  /** Writes the first cells of every column. */
  void write(ColumnCells[] from, int count) throws IOException {
    for (int i = 0; i < from.length; i++) {
      from[i].write(cells.getColumnWriter(schema.getColumns().get(i)), count);
    }
    for (int row = 0; row < count; row++) {
      cells.endRecord();
    }
    rows += count;
    if (rows >= MAX_ROWS || cells.getBufferedSize() >= MAX_BYTES) {
      end();
      begin();
    }
  }

  private void end() throws IOException {
    file.startBlock(rows);
    cells.flush();
    pages.flushToFileWriter(file);
    file.endBlock();
    discard();
  }

  private void discard() {
    cells.close();
    pages.close();
  }

  /** Ends the last group, and the file with what the columns mean. */
  @Override
  public void close() throws IOException {
    try (file) {
      if (rows > 0) {
        end();
      }
      file.end(new TreeMap<>(Schema.meanings(columns)));
    }
  }
}
