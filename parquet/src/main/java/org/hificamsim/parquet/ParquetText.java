package org.hificamsim.parquet;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.apache.parquet.column.ColumnDescriptor;
import org.apache.parquet.column.ColumnReadStore;
import org.apache.parquet.column.ColumnReader;
import org.apache.parquet.column.impl.ColumnReadStoreImpl;
import org.apache.parquet.hadoop.metadata.BlockMetaData;
import org.apache.parquet.schema.MessageType;
import org.hificamsim.core.InputException;

/** The rows of a Parquet file as CSV has them. */
final class ParquetText {
  private ParquetText() {}

  /**
   * Gives each row.
   *
   * @throws InputException when it is no Parquet file that {@link ParquetRows} wrote
   */
  static void each(Path path, Consumer<String> row) throws IOException {
    try (StoredFile file = new StoredFile(path)) {
      for (BlockMetaData group : file.groups()) {
        each(cells(file, group), group.getRowCount(), row);
      }
    } catch (InputException e) {
      throw e; // what takes the rows expected others
    } catch (IOException | RuntimeException e) {
      throw new InputException(path + " is broken, expected what 'hificamsim' writes", e);
    }
  }

  private static List<Supplier<String>> cells(StoredFile file, BlockMetaData group) {
    MessageType schema = file.schema();
    ColumnReadStore columns =
        new ColumnReadStoreImpl(
            new StoredPages(file, group), new NoRecord(schema), schema, file.writer());
    return schema.getColumns().stream()
        .<Supplier<String>>map(column -> cell(columns.getColumnReader(column), column))
        .toList();
  }

  private static Supplier<String> cell(ColumnReader reader, ColumnDescriptor column) {
    return () -> {
      boolean missing = reader.getCurrentDefinitionLevel() < column.getMaxDefinitionLevel();
      String text = missing ? "" : text(reader, column);
      reader.consume();
      return text;
    };
  }

  private static String text(ColumnReader reader, ColumnDescriptor column) {
    return switch (column.getPrimitiveType().getPrimitiveTypeName()) {
      case INT32 -> Integer.toString(reader.getInteger());
      case INT64 -> Long.toString(reader.getLong());
      case DOUBLE -> Double.toString(reader.getDouble());
      default -> reader.getBinary().toStringUsingUTF8();
    };
  }

  private static void each(List<Supplier<String>> cells, long rows, Consumer<String> taker) {
    for (long row = 0; row < rows; row++) {
      taker.accept(cells.stream().map(Supplier::get).collect(Collectors.joining(",")));
    }
  }
}
