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
 * Writes a Parquet file. Only one group of rows is in memory at a time, so that the memory does not
 * depend on the number of rows.
 */
final class ParquetRows implements Rows {
  /** The largest group of rows, which readers read or skip as a whole. */
  static final int MAX_ROWS = 1 << 20;

  static final long MAX_BYTES = 16 << 20;

  /** The number of rows after which the size of a group is checked. */
  static final int BATCH = 4096;

  /** The number of bytes of a text that statistics keep. */
  private static final int TEXT_BYTES = 64;

  /** Parquet's definition level of a value that is not null. */
  private static final int PRESENT = 1;

  private final List<? extends Column<?>> columns;
  private final MessageType schema;
  private final ParquetProperties properties;
  private final ParquetFileWriter file;
  private final ColumnWriter[] cells;

  /** Encoded texts, which are kept because the same names occur in every step. */
  private final Map<String, Binary> encoded = new HashMap<>();

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
            TEXT_BYTES,
            TEXT_BYTES,
            true);
    file.start();
    beginGroup();
  }

  /** The Parquet type of a column; only floating numbers may be missing. */
  private static Type type(Column<?> column) {
    return switch (column.kind()) {
      case INT -> required(INT32).named(column.name());
      case LONG -> required(INT64).named(column.name());
      case DOUBLE -> optional(DOUBLE).named(column.name());
      case TEXT -> required(BINARY).as(stringType()).named(column.name());
    };
  }

  /**
   * Returns the properties of a file in which steps are encoded as differences, and other columns
   * by a dictionary.
   */
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

  private void beginGroup() {
    pages =
        new ColumnChunkPageWriteStore(
            new Gzip(), schema, properties.getAllocator(), TEXT_BYTES, true);
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
      default -> throw wrongKind("whole number");
    }
    column++;
  }

  /** {@inheritDoc} NaN becomes null. */
  @Override
  public void add(double number) {
    if (columns.get(column).kind() != Column.Kind.DOUBLE) {
      throw wrongKind("floating number");
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
      throw wrongKind("text");
    }
    cells[column++].write(encoded.computeIfAbsent(text, Binary::fromString), 0, 0);
  }

  private IllegalStateException wrongKind(String kind) {
    Column<?> current = columns.get(column);
    return new IllegalStateException(
        current.name() + " is " + current.kind() + ", but a cell is a " + kind);
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
      beginGroup();
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
   * Ends the last group and the file, which gets the meanings of the columns. Later calls have no
   * effect.
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

  /** The units and meanings of the columns, as {@code NAME.unit} and {@code NAME.meaning}. */
  private Map<String, String> meanings() {
    Map<String, String> meanings = new TreeMap<>();
    for (Column<?> described : columns) {
      meanings.put(described.name() + ".unit", described.unit());
      meanings.put(described.name() + ".meaning", described.meaning());
    }
    return meanings;
  }
}
