package org.hificamsim.parquet;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import org.apache.parquet.column.ColumnDescriptor;
import org.apache.parquet.column.page.PageReadStore;
import org.apache.parquet.column.page.PageReader;
import org.apache.parquet.hadoop.metadata.BlockMetaData;
import org.apache.parquet.hadoop.metadata.ColumnChunkMetaData;

/** The pages of a row group, by column. */
record StoredPages(StoredFile file, BlockMetaData group) implements PageReadStore {
  @Override
  public PageReader getPageReader(ColumnDescriptor column) {
    ColumnChunkMetaData chunk =
        group.getColumns().stream()
            .filter(one -> List.of(column.getPath()).equals(List.of(one.getPath().toArray())))
            .findFirst()
            .orElseThrow();
    try {
      return new ColumnPages(
          file.bytes(chunk.getStartingPos(), chunk.getTotalSize()), chunk.getValueCount());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public long getRowCount() {
    return group.getRowCount();
  }
}
