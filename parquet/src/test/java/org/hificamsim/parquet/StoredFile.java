package org.hificamsim.parquet;

import java.io.ByteArrayInputStream;
import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Path;
import java.util.List;
import java.util.StringJoiner;
import java.util.function.Consumer;
import org.apache.parquet.column.ColumnDescriptor;
import org.apache.parquet.column.page.PageReadStore;
import org.apache.parquet.column.page.PageReader;
import org.apache.parquet.example.data.Group;
import org.apache.parquet.example.data.simple.convert.GroupRecordConverter;
import org.apache.parquet.format.converter.ParquetMetadataConverter;
import org.apache.parquet.hadoop.metadata.BlockMetaData;
import org.apache.parquet.hadoop.metadata.ColumnChunkMetaData;
import org.apache.parquet.hadoop.metadata.ColumnPath;
import org.apache.parquet.hadoop.metadata.FileMetaData;
import org.apache.parquet.hadoop.metadata.ParquetMetadata;
import org.apache.parquet.io.ColumnIOFactory;
import org.apache.parquet.io.RecordReader;
import org.apache.parquet.schema.MessageType;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.Io;

/** Reads a Parquet file, because Parquet's own reader of files needs Hadoop. */
final class StoredFile implements Closeable {
  /** The bytes after the footer: its length, and the format's four letters. */
  private static final int TAIL_BYTES = 8;

  private final RandomAccessFile in;
  private final ParquetMetadata footer;

  StoredFile(Path path) throws IOException {
    in = new RandomAccessFile(path.toFile(), "r");
    try {
      footer = footer(in.length() - TAIL_BYTES);
    } catch (IOException | RuntimeException e) {
      in.close();
      throw e;
    }
  }

  /**
   * Reads a table row by row, each as a line of CSV.
   *
   * @throws InputException when the file is broken
   */
  static void forEachRow(Path path, Consumer<String> row) throws IOException {
    try (StoredFile file = new StoredFile(path)) {
      MessageType schema = file.metadata().getSchema();
      for (BlockMetaData group : file.groups()) {
        forEachRow(schema, file.pages(group), row);
      }
    } catch (IOException | RuntimeException e) {
      throw new InputException(path + " is broken", e);
    }
  }

  private static void forEachRow(MessageType schema, PageReadStore group, Consumer<String> row) {
    RecordReader<Group> records =
        new ColumnIOFactory()
            .getColumnIO(schema)
            .getRecordReader(group, new GroupRecordConverter(schema));
    for (long i = 0; i < group.getRowCount(); i++) {
      Group record = records.read();
      StringJoiner cells = new StringJoiner(",");
      for (int column = 0; column < schema.getFieldCount(); column++) {
        boolean isMissing = record.getFieldRepetitionCount(column) == 0;
        cells.add(isMissing ? "" : record.getValueToString(column, 0));
      }
      row.accept(cells.toString());
    }
  }

  private ParquetMetadata footer(long end) throws IOException {
    in.seek(end);
    int length = Integer.reverseBytes(in.readInt());
    return new ParquetMetadataConverter()
        .readParquetMetadata(
            new ByteArrayInputStream(bytes(end - length, length)),
            ParquetMetadataConverter.NO_FILTER);
  }

  private byte[] bytes(long from, long length) throws IOException {
    in.seek(from);
    if (length > in.length() - from) {
      throw new EOFException();
    }
    byte[] bytes = new byte[Math.toIntExact(length)];
    in.readFully(bytes);
    return bytes;
  }

  /** The columns with their metadata. */
  FileMetaData metadata() {
    return footer.getFileMetaData();
  }

  List<BlockMetaData> groups() {
    return footer.getBlocks();
  }

  /** The pages of a group of rows, which are read column by column. */
  PageReadStore pages(BlockMetaData group) {
    return new PageReadStore() {
      @Override
      public PageReader getPageReader(ColumnDescriptor column) {
        return Io.get(() -> columnPages(group, ColumnPath.get(column.getPath())));
      }

      @Override
      public long getRowCount() {
        return group.getRowCount();
      }
    };
  }

  private ColumnPages columnPages(BlockMetaData group, ColumnPath path) throws IOException {
    ColumnChunkMetaData chunk =
        group.getColumns().stream()
            .filter(column -> column.getPath().equals(path))
            .findFirst()
            .orElseThrow();
    byte[] bytes = bytes(chunk.getStartingPos(), chunk.getTotalSize());
    return new ColumnPages(bytes, chunk.getValueCount());
  }

  @Override
  public void close() throws IOException {
    in.close();
  }
}
