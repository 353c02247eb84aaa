package org.hificamsim.parquet;

import static org.apache.parquet.schema.LogicalTypeAnnotation.stringType;
import static org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName.BINARY;
import static org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName.DOUBLE;
import static org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName.INT32;
import static org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName.INT64;
import static org.apache.parquet.schema.Types.optional;
import static org.apache.parquet.schema.Types.required;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.apache.parquet.schema.MessageType;
import org.apache.parquet.schema.Type;
import org.hificamsim.runs.output.Column;

/** The columns as Parquet knows them. */
final class Schema {
  private Schema() {}

  /** The columns with their types; floating numbers alone may be missing. */
  static MessageType of(List<? extends Column<?>> columns) {
    return new MessageType("rows", columns.stream().map(Schema::type).toList());
  }

  private static Type type(Column<?> column) {
    return switch (column.kind()) {
      case INT -> required(INT32).named(column.name());
      case LONG -> required(INT64).named(column.name());
      case DOUBLE -> optional(DOUBLE).named(column.name());
      case TEXT -> required(BINARY).as(stringType()).named(column.name());
    };
  }

  /** What they say: {@code NAME.unit} and {@code NAME.meaning}. */
  static Map<String, String> meanings(List<? extends Column<?>> columns) {
    Map<String, String> meanings = new TreeMap<>();
    for (Column<?> column : columns) {
      meanings.put(column.name() + ".unit", column.unit());
      meanings.put(column.name() + ".meaning", column.meaning());
    }
    return meanings;
  }
}
