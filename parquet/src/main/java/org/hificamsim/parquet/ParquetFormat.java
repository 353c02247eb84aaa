package org.hificamsim.parquet;

import java.io.IOException;
import java.nio.file.Path;
import java.util.StringJoiner;
import java.util.function.Consumer;
import org.apache.parquet.column.page.PageReadStore;
import org.apache.parquet.example.data.Group;
import org.apache.parquet.example.data.simple.convert.GroupRecordConverter;
import org.apache.parquet.hadoop.metadata.BlockMetaData;
import org.apache.parquet.io.ColumnIOFactory;
import org.apache.parquet.io.RecordReader;
import org.apache.parquet.schema.MessageType;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Rows;
import org.hificamsim.runs.output.Table;
import org.hificamsim.runs.output.TableFormat;

/** Columns of numbers, compressed: {@code --format parquet}. */
public final class ParquetFormat implements TableFormat {
  @Override
  public String name() {
    return "parquet";
  }

  @Override
  public Rows create(Table<?> table, OutputFolder folder) throws IOException {
    return new ParquetRows(folder.stream(table.file(name())), table.columns());
  }

  @Override
  public void each(Path path, Consumer<String> row) throws IOException {
    try (StoredFile file = new StoredFile(path)) {
      MessageType schema = file.about().getSchema();
      for (BlockMetaData group : file.groups()) {
        each(schema, file.pages(group), row);
      }
    } catch (InputException e) {
      throw e; // what takes the rows expected others
    } catch (IOException | RuntimeException e) {
      throw new InputException(path + " is broken, expected what 'hificamsim' writes", e);
    }
  }

  private static void each(MessageType schema, PageReadStore group, Consumer<String> row) {
    RecordReader<Group> records =
        new ColumnIOFactory()
            .getColumnIO(schema)
            .getRecordReader(group, new GroupRecordConverter(schema));
    for (long i = 0; i < group.getRowCount(); i++) {
      Group record = records.read();
      StringJoiner cells = new StringJoiner(",");
      for (int column = 0; column < schema.getFieldCount(); column++) {
        cells.add(text(record, column));
      }
      row.accept(cells.toString());
    }
  }

  private static String text(Group record, int column) {
    boolean missing = record.getFieldRepetitionCount(column) == 0;
    return missing ? "" : record.getValueToString(column, 0);
  }
}
