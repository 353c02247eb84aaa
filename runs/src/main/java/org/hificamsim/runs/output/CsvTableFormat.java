package org.hificamsim.runs.output;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Rows;

/** Tables as text, which everything reads. */
public final class CsvTableFormat implements TableFormat {
  @Override
  public String name() {
    return TableFormats.CSV;
  }

  @Override
  public Rows create(Table<?> table, OutputFolder folder) throws IOException {
    return table.create(folder);
  }

  @Override
  public void each(Path file, Consumer<String> row) throws IOException {
    try (BufferedReader reader = Files.newBufferedReader(file)) {
      reader.readLine();
      for (String line; (line = reader.readLine()) != null; ) {
        row.accept(line);
      }
    }
  }
}
