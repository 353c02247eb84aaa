package org.hificamsim.runs.output;

import com.fasterxml.jackson.dataformat.csv.CsvFactory;
import com.fasterxml.jackson.dataformat.csv.CsvGenerator;
import com.fasterxml.jackson.dataformat.csv.CsvSchema;
import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;

/** A CSV file under way: a header, then one row after the other, each value in its column. */
public final class CsvTable implements Closeable {
  private final CsvGenerator out;

  /** Starts a table with these columns. */
  public CsvTable(Writer writer, String... columns) throws IOException {
    CsvSchema.Builder schema = CsvSchema.builder();
    for (String column : columns) {
      schema.addColumn(column);
    }
    out = new CsvFactory().createGenerator(writer);
    out.enable(CsvGenerator.Feature.STRICT_CHECK_FOR_QUOTING);
    out.setSchema(schema.build().withHeader());
  }

  /** Writes one row of numbers (whole or floating) and texts. */
  public void row(Object... values) {
    try {
      out.writeStartArray();
      for (Object value : values) {
        write(value);
      }
      out.writeEndArray();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void write(Object value) throws IOException {
    if (value instanceof Integer number) {
      out.writeNumber(number);
    } else if (value instanceof Long number) {
      out.writeNumber(number);
    } else if (value instanceof Double number) {
      writeDouble(number);
    } else {
      out.writeString(value.toString());
    }
  }

  /** NaN is an empty field, which pandas and R read as missing. */
  private void writeDouble(double number) throws IOException {
    if (Double.isNaN(number)) {
      out.writeString("");
    } else {
      out.writeNumber(number);
    }
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
