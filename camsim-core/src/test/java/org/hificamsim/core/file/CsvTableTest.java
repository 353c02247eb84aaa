package org.hificamsim.core.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CsvTableTest {
  @Test
  void writesNumbersLikeJavaButNaNAsEmptyCell() throws IOException {
    assertEquals(
        "a;b;c;d\r\n1;-0.0;;1.0E-5\r\n-9223372036854775808;Infinity;0.1;100.0\r\n",
        written(
            rows -> {
              rows.add(1);
              rows.add(-0.0);
              rows.add(Double.NaN);
              rows.add(1e-5);
              rows.end();
              rows.add(Long.MIN_VALUE);
              rows.add(Double.POSITIVE_INFINITY);
              rows.add(0.1);
              rows.add(100.0);
              rows.end();
            }));
  }

  @Test
  void acceptsShortRowAfterLongRow() throws IOException {
    String row = "-9223372036854775808;".repeat(100);
    assertEquals(
        "a;b;c;d\r\n" + row + "1\r\n2\r\n",
        written(
            rows -> {
              for (int cell = 0; cell < 100; cell++) {
                rows.add(Long.MIN_VALUE);
              }
              rows.add(1);
              rows.end();
              rows.add(2);
              rows.end();
            }));
  }

  @Test
  void writesEveryDoubleAsJavaDoes() throws IOException {
    Random random = new Random(1);
    StringBuilder expected = new StringBuilder("a;b;c;d\r\n");
    String text =
        written(
            rows -> {
              for (int i = 0; i < 20_000; i++) {
                double number = Double.longBitsToDouble(random.nextLong());
                rows.add(number);
                rows.end();
                expected.append(Double.isNaN(number) ? "" : Double.toString(number)).append("\r\n");
              }
            });
    assertEquals(expected.toString(), text);
  }

  @Test
  void quotesSeparatorsQuotesAndLineEnds() throws IOException {
    assertEquals(
        "a;b;c;d\r\n\";\";\"\"\"\";\"\n\";\"c\rd\"\r\n\"1;2\";\"a \"\"b\"\"\";\"c\nd\";e,f\r\n",
        written(
            rows -> {
              rows.add(";");
              rows.add("\"");
              rows.add("\n");
              rows.add("c\rd");
              rows.end();
              rows.add("1;2");
              rows.add("a \"b\"");
              rows.add("c\nd");
              rows.add("e,f");
              rows.end();
            }));
  }

  @Test
  void closeClosesTheFile() throws IOException {
    boolean[] closed = {false};
    StringWriter file =
        new StringWriter() {
          @Override
          public void close() {
            closed[0] = true;
          }
        };
    new CsvTable(file, "a", ',', "\n").close();
    assertTrue(closed[0]);
  }

  private interface Filling {
    void fill(CsvTable rows) throws IOException;
  }

  private static String written(Filling filling) throws IOException {
    StringWriter text = new StringWriter();
    try (CsvTable rows = new CsvTable(text, "a;b;c;d", ';', "\r\n")) {
      filling.fill(rows);
    }
    return text.toString();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "=1+1 | '=1+1",
        "@sum | '@sum",
        "+a | '+a",
        "-b | '-b",
        "-3.5 | -3.5",
        "a=b | a=b",
        "\"\" | \"\"",
        "' | '",
        "'a | 'a"
      })
  void escapesFormulasAndRestoresTheOriginal(String text, String written) {
    assertEquals(written, CsvTable.harmless(text));
    assertEquals(text, CsvTable.original(written));
  }
}
