package org.hificamsim.parquet;

import java.io.ByteArrayInputStream;
import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Path;
import java.util.List;
import org.apache.parquet.column.ColumnDescriptor;
import org.apache.parquet.column.page.PageReadStore;
import org.apache.parquet.column.page.PageReader;
import org.apache.parquet.format.converter.ParquetMetadataConverter;
import org.apache.parquet.hadoop.metadata.BlockMetaData;
import org.apache.parquet.hadoop.metadata.ColumnChunkMetaData;
import org.apache.parquet.hadoop.metadata.ColumnPath;
import org.apache.parquet.hadoop.metadata.FileMetaData;
import org.apache.parquet.hadoop.metadata.ParquetMetadata;
import org.hificamsim.core.file.Io;

/** A Parquet file and its footer. Parquet's own class for that does not run without Hadoop. */
final class StoredFile implements Closeable {
  private static final int END = 8; // the footer's length, and four letters

  private final RandomAccessFile in;
  private final ParquetMetadata footer;

  StoredFile(Path path) throws IOException {
    in = new RandomAccessFile(path.toFile(), "r");
    try {
      footer = footer(in.length() - END);
    } catch (IOException | RuntimeException e) {
      in.close();
      throw e;
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

  /** The columns, and what is said of them. */
  FileMetaData about() {
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
            .filter(one -> one.getPath().equals(path))
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
