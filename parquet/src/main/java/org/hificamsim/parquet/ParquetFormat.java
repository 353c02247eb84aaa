package org.hificamsim.parquet;

import java.io.IOException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Rows;
import org.hificamsim.runs.output.Table;
import org.hificamsim.runs.output.TableFormat;

/** Writes tables as Parquet files: typed and compressed columns. */
public final class ParquetFormat implements TableFormat {
  @Override
  public String name() {
    return "parquet";
  }

  @Override
  public Rows create(Table<?> table, OutputFolder folder) throws IOException {
    return new ParquetRows(folder.stream(table.file(name())), table.columns());
  }
}
