package org.hificamsim.parquet;

import java.util.Arrays;
import org.apache.parquet.io.api.Converter;
import org.apache.parquet.io.api.GroupConverter;
import org.apache.parquet.io.api.PrimitiveConverter;
import org.apache.parquet.schema.MessageType;

/** Makes nothing of what is read: cells are asked for one by one. */
final class NoRecord extends GroupConverter {
  private final PrimitiveConverter[] columns;

  NoRecord(MessageType schema) {
    columns = new PrimitiveConverter[schema.getFieldCount()];
    Arrays.setAll(columns, i -> new PrimitiveConverter() {});
  }

  @Override
  public Converter getConverter(int column) {
    return columns[column];
  }

  @Override
  public void start() {}

  @Override
  public void end() {}
}
