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
import org.hificamsim.runs.output.StepColumn;

/** The columns as Parquet knows them. */
final class Schema {
  private Schema() {}

  /** The columns with their types; floating numbers alone may be missing. */
  static MessageType of(List<StepColumn> columns) {
    return new MessageType("rows", columns.stream().map(Schema::type).toList());
  }

  private static Type type(StepColumn column) {
    return switch (column.kind()) {
      case INT -> required(INT32).named(column.label());
      case LONG -> required(INT64).named(column.label());
      case DOUBLE -> optional(DOUBLE).named(column.label());
      case TEXT -> required(BINARY).as(stringType()).named(column.label());
    };
  }

  /** What they say: {@code NAME.unit} and {@code NAME.meaning}. */
  static Map<String, String> meanings(List<StepColumn> columns) {
    Map<String, String> meanings = new TreeMap<>();
    for (StepColumn column : columns) {
      meanings.put(column.label() + ".unit", column.unit());
      meanings.put(column.label() + ".meaning", column.meaning());
    }
    return meanings;
  }
}
