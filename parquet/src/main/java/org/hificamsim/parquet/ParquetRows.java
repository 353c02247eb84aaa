package org.hificamsim.parquet;

import static org.apache.parquet.schema.LogicalTypeAnnotation.stringType;
import static org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName.BINARY;
import static org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName.DOUBLE;
import static org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName.INT32;
import static org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName.INT64;
import static org.apache.parquet.schema.Types.optional;
import static org.apache.parquet.schema.Types.required;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.apache.parquet.bytes.HeapByteBufferAllocator;
import org.apache.parquet.column.ColumnWriteStore;
import org.apache.parquet.column.ColumnWriter;
import org.apache.parquet.column.ParquetProperties;
import org.apache.parquet.column.ParquetProperties.WriterVersion;
import org.apache.parquet.hadoop.ColumnChunkPageWriteStore;
import org.apache.parquet.hadoop.ParquetFileWriter;
import org.apache.parquet.io.api.Binary;
import org.apache.parquet.schema.MessageType;
import org.apache.parquet.schema.Type;
import org.hificamsim.core.file.Rows;
import org.hificamsim.runs.output.Column;

/**
 * A Parquet file under way. One group of rows is in memory at a time, so that memory stays the same
 * however many rows there are.
 */
final class ParquetRows implements Rows {
  /** What readers take at once, or skip. */
  static final int MAX_ROWS = 1 << 20;

  static final long MAX_BYTES = 16 << 20;

  /** Rows after which the size of a group is looked at. */
  static final int BATCH = 4096;

  private static final int TEXT = 64; // bytes of one in the statistics
  private static final int PRESENT = 1; // Parquet's level of definition

  private final List<? extends Column<?>> columns;
  private final MessageType schema;
  private final ParquetProperties properties;
  private final ParquetFileWriter file;
  private final ColumnWriter[] cells;
  private final Map<String, Binary> known = new HashMap<>(); // names come again in every step
  private ColumnChunkPageWriteStore pages;
  private ColumnWriteStore group;
  private int column;
  private int rows;
  private boolean closed;

  ParquetRows(OutputStream out, List<? extends Column<?>> columns) throws IOException {
    this.columns = columns;
    this.schema = new MessageType("rows", columns.stream().map(ParquetRows::type).toList());
    this.properties = properties(columns);
    this.cells = new ColumnWriter[columns.size()];
    this.file =
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

  /** A column as Parquet knows it; floating numbers alone may be missing. */
  private static Type type(Column<?> column) {
    return switch (column.kind()) {
      case INT -> required(INT32).named(column.name());
      case LONG -> required(INT64).named(column.name());
      case DOUBLE -> optional(DOUBLE).named(column.name());
      case TEXT -> required(BINARY).as(stringType()).named(column.name());
    };
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
    group = properties.newColumnWriteStore(schema, pages);
    for (int i = 0; i < cells.length; i++) {
      cells[i] = group.getColumnWriter(schema.getColumns().get(i));
    }
    rows = 0;
  }

  @Override
  public void add(long number) {
    switch (columns.get(column).kind()) {
      case INT -> cells[column].write(Math.toIntExact(number), 0, 0);
      case LONG -> cells[column].write(number, 0, 0);
      default -> throw another("whole number");
    }
    column++;
  }

  /** NaN is null. */
  @Override
  public void add(double number) {
    if (columns.get(column).kind() != Column.Kind.DOUBLE) {
      throw another("floating number");
    }
    if (Double.isNaN(number)) {
      cells[column++].writeNull(0, 0);
    } else {
      cells[column++].write(number, 0, PRESENT);
    }
  }

  @Override
  public void add(String text) {
    if (columns.get(column).kind() != Column.Kind.TEXT) {
      throw another("text");
    }
    cells[column++].write(known.computeIfAbsent(text, Binary::fromString), 0, 0);
  }

  private IllegalStateException another(String kind) {
    Column<?> of = columns.get(column);
    return new IllegalStateException(of.name() + " is " + of.kind() + ", but a cell is a " + kind);
  }

  @Override
  public void end() {
    if (column != cells.length) {
      throw new IllegalStateException(column + " cells, expected " + cells.length);
    }
    column = 0;
    group.endRecord();
    rows++;
    if (rows % BATCH == 0 && (rows >= MAX_ROWS || group.getBufferedSize() >= MAX_BYTES)) {
      try {
        endGroup();
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
      begin();
    }
  }

  private void endGroup() throws IOException {
    file.startBlock(rows);
    group.flush();
    pages.flushToFileWriter(file);
    file.endBlock();
    group.close();
    pages.close();
  }

  /**
   * Ends the last group, and the file with what the columns mean; after the first call, nothing.
   */
  @Override
  public void close() throws IOException {
    if (!closed) {
      closed = true;
      try (file) {
        if (rows > 0) {
          endGroup();
        }
        file.end(meanings());
      }
    }
  }

  /** What the columns say: {@code NAME.unit} and {@code NAME.meaning}. */
  private Map<String, String> meanings() {
    Map<String, String> meanings = new TreeMap<>();
    for (Column<?> one : columns) {
      meanings.put(one.name() + ".unit", one.unit());
      meanings.put(one.name() + ".meaning", one.meaning());
    }
    return meanings;
  }
}
