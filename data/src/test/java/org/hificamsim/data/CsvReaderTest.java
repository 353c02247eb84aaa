package org.hificamsim.data;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.zip.GZIPOutputStream;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;

class CsvReaderTest {
  private static final List<String> COLUMNS = List.of("a", "b");
  private static final String EXPECTED = "a table of the test";

  @TempDir Path folder;

  @Test
  void findsCellsByColumnName() {
    CsvRows table = open("b,a,c\n1,2,x\n3,4,\"y,\"\"z\"\n").readAll(COLUMNS);
    assertEquals(List.of("b", "a", "c"), table.columns());
    assertEquals(2, table.rows().size());
    CsvRow last = table.rows().get(1);
    assertEquals(3, last.line());
    assertEquals(List.of("3", "4", "y,\"z"), last.texts());
    assertEquals(4, last.number("a", 0, 4, "at most 4"));
    assertTrue(last.has("c"));
    assertFalse(last.has("d"));
    assertError(":3:3: a is '4', expected at most 3", () -> last.number("a", 0, 3, "at most 3"));
    assertError(":3:5: c is 'y,\"z', expected a number", () -> last.numberOrNaN("c"));
  }

  @Test
  void emptyCellIsNotANumber() {
    CsvRow row = open("a,b\n,1\n").readAll(COLUMNS).rows().get(0);
    assertEquals(Double.NaN, row.numberOrNaN("a"));
    assertError(":2:1: a is '', expected 0 to 1", () -> row.number("a", 0, 1, "0 to 1"));
  }

  @Test
  void ignoresBlanksAroundValuesAndEmptyLines() {
    CsvRows table = open(" a ,b\r\n\n  \n\t1 x , \n\n").readAll(COLUMNS);
    assertEquals(List.of("1 x", ""), table.rows().get(0).texts());
    assertEquals(4, table.rows().get(0).line());
    assertEquals(1, table.rows().size());
  }

  @Test
  void keepsBlanksInCommaSeparatedTables() {
    CsvRows table =
        CsvReader.openCommaSeparated(file(" a;,b\n x,1 \n"), EXPECTED).readAll(List.of("b"));
    assertEquals(List.of(" a;", "b"), table.columns());
    assertEquals(List.of(" x", "1 "), table.rows().get(0).texts());
  }

  @Test
  void readsSemicolonsDecimalCommasAndByteOrderMark() {
    CsvRow row = open("\ufeffa;b\n1,5;-2,25e1\n").readAll(COLUMNS).rows().get(0);
    assertEquals(1.5, row.number("a", 0, 2, "0 to 2"));
    assertEquals(-22.5, row.numberOrNaN("b"));
    assertEquals(1.5, row.coordinate(0, "a"));
  }

  @Test
  void readsTabSeparatedTables() {
    assertEquals(
        List.of("1", "", "2"), open("a\tb\tc\n1\t\t2\n").readAll(COLUMNS).rows().get(0).texts());
  }

  @Test
  void rowsMayDifferInLengthWithoutHeader() {
    try (CsvReader table = open("1,2\n3\n")) {
      assertEquals(2, table.next().count());
      CsvRow last = table.next();
      assertEquals(3, last.number(0, "x"));
      assertError(":2:1: the line has no y, expected a finite number", () -> last.number(1, "y"));
      assertNull(table.next());
    }
  }

  @Test
  void readsTableWithColumnsButNoRows() {
    CsvRows table = open("a,b\n").readAll(COLUMNS);
    assertEquals(COLUMNS, table.columns());
    assertEquals(List.of(), table.rows());
  }

  @Test
  void rejectsMalformedTablesWithLineAndColumn() {
    assertError(
        ":1:1: the table is empty, expected " + EXPECTED, () -> open("\n").readAll(COLUMNS));
    assertError(
        ":1:1: the columns are a,c, expected a,b among them", () -> open("a,c\n").readAll(COLUMNS));
    assertError(
        ":3:1: the row has 1 cells, expected 2", () -> open("a,b\n1,2\n3\n").readAll(COLUMNS));
    InputException open =
        assertThrows(InputException.class, () -> open("a,b\n1,2\n\"3,4\n").readAll(COLUMNS));
    assertTrue(open.getMessage().endsWith(", expected " + EXPECTED), open.getMessage());
    assertTrue(open.getMessage().startsWith(folder.resolve("t.csv") + ":"), open.getMessage());
  }

  @Test
  void rejectsMissingFile() {
    Path missing = folder.resolve("missing.csv");
    InputException error =
        assertThrows(InputException.class, () -> CsvReader.open(missing, EXPECTED));
    assertEquals(missing + ":1:1: no such file, expected a file", error.getMessage());
  }

  @Test
  void rejectsTruncatedCompressedTable() throws IOException {
    StringBuilder text = new StringBuilder("a,b\n");
    SplittableRandom random = new SplittableRandom(1);
    for (int row = 0; row < 10_000; row++) {
      text.append(random.nextInt()).append(',').append(random.nextInt()).append('\n');
    }
    ByteArrayOutputStream compressed = new ByteArrayOutputStream();
    try (OutputStream out = new GZIPOutputStream(compressed)) {
      out.write(text.toString().getBytes(StandardCharsets.UTF_8));
    }
    Path file = folder.resolve("t.csv.gz");
    Files.write(file, Arrays.copyOf(compressed.toByteArray(), compressed.size() / 2));
    List<CsvRow> rows = new ArrayList<>();
    try (CsvReader table = CsvReader.open(file, EXPECTED)) {
      InputException error = assertThrows(InputException.class, () -> table.forEachRow(rows::add));
      assertTrue(error.getMessage().endsWith(", expected " + EXPECTED), error.getMessage());
    }
    assertTrue(rows.size() > 1000, "rows before the end: " + rows.size());
    Files.writeString(file, "a,b\n1,2\n");
    assertThrows(InputException.class, () -> CsvReader.open(file, EXPECTED));
  }

  private void assertError(String message, Executable read) {
    InputException error = assertThrows(InputException.class, read);
    assertEquals(folder.resolve("t.csv") + message, error.getMessage());
  }

  private CsvReader open(String text) {
    return CsvReader.open(file(text), EXPECTED);
  }

  private Path file(String text) {
    try {
      return Files.writeString(folder.resolve("t.csv"), text);
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
