package org.hificamsim.parquet;

import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
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
  public void each(Path file, Consumer<String> row) throws IOException {
    ParquetText.each(file, row);
  }
}
