package org.hificamsim.runs.output;

import com.fasterxml.jackson.dataformat.csv.CsvFactory;
import com.fasterxml.jackson.dataformat.csv.CsvGenerator;
import com.fasterxml.jackson.dataformat.csv.CsvSchema;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.util.List;

/** A CSV file under way: a header, then one row after the other, each value in its column. */
public final class CsvTable implements TableRows {
  private final CsvGenerator out;
  private boolean inRow;

  /** Starts a table with these columns. */
  public CsvTable(Writer writer, List<String> columns) throws IOException {
    CsvSchema.Builder schema = CsvSchema.builder();
    for (String column : columns) {
      schema.addColumn(column);
    }
    out = new CsvFactory().createGenerator(writer);
    out.enable(CsvGenerator.Feature.STRICT_CHECK_FOR_QUOTING);
    out.setSchema(schema.build().withHeader());
  }

  @Override
  public void add(long number) {
    cell(() -> out.writeNumber(number));
  }

  /** NaN is an empty field, which pandas and R read as missing. */
  @Override
  public void add(double number) {
    if (Double.isNaN(number)) {
      add("");
    } else {
      cell(() -> out.writeNumber(number));
    }
  }

  @Override
  public void add(String text) {
    cell(() -> out.writeString(text));
  }

  @Override
  public void end() {
    cell(out::writeEndArray);
    inRow = false;
  }

  private void cell(Writing writing) {
    try {
      if (!inRow) {
        out.writeStartArray();
        inRow = true;
      }
      writing.write();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private interface Writing {
    void write() throws IOException;
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
