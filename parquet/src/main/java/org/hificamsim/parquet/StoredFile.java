package org.hificamsim.parquet;

import java.io.ByteArrayInputStream;
import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.apache.parquet.format.converter.ParquetMetadataConverter;
import org.apache.parquet.hadoop.metadata.BlockMetaData;
import org.apache.parquet.hadoop.metadata.ParquetMetadata;
import org.apache.parquet.schema.MessageType;

/** A Parquet file and its footer. Parquet's own class for that does not load without Hadoop. */
final class StoredFile implements Closeable {
  private static final int END = 8; // the footer's length, and four letters

  private final FileChannel channel;
  private final ParquetMetadata footer;

  StoredFile(Path path) throws IOException {
    channel = FileChannel.open(path);
    try {
      footer = footer();
    } catch (IOException | RuntimeException e) {
      channel.close();
      throw e;
    }
  }

  private ParquetMetadata footer() throws IOException {
    long end = channel.size() - END;
    int length = ByteBuffer.wrap(bytes(end, END)).order(ByteOrder.LITTLE_ENDIAN).getInt();
    return new ParquetMetadataConverter()
        .readParquetMetadata(
            new ByteArrayInputStream(bytes(end - length, length)),
            ParquetMetadataConverter.NO_FILTER);
  }

  MessageType schema() {
    return footer.getFileMetaData().getSchema();
  }

  /** What wrote it. */
  String writer() {
    return footer.getFileMetaData().getCreatedBy();
  }

  /** What is said of it beside its columns. */
  Map<String, String> meanings() {
    return footer.getFileMetaData().getKeyValueMetaData();
  }

  List<BlockMetaData> groups() {
    return footer.getBlocks();
  }

  /** A part of the file. */
  byte[] bytes(long from, long length) throws IOException {
    if (from < 0 || length < 0 || length > channel.size() - from) {
      throw new EOFException();
    }
    ByteBuffer bytes = ByteBuffer.allocate(Math.toIntExact(length));
    while (bytes.hasRemaining() && channel.read(bytes, from + bytes.position()) >= 0) {
      // it may give less than was asked for
    }
    return bytes.array();
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
