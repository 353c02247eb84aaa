package org.hificamsim.core.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.io.Reader;
import java.io.StringReader;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.zip.GZIPOutputStream;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TextLinesTest {
  @TempDir Path folder;

  @Test
  void numbersLinesAndSkipsByteOrderMark() throws IOException {
    Path file = Files.writeString(folder.resolve("a.csv"), "\ufeffx\r\n\ufeffy\n");
    try (TextLines lines = TextLines.open(file)) {
      assertTrue(lines.next());
      assertEquals("x", lines.text());
      assertTrue(lines.next());
      assertEquals("\ufeffy", lines.text());
      assertEquals(file + ":2:1: no", lines.place().error("no").getMessage());
      assertFalse(lines.next());
    }
  }

  @Test
  void skipsEmptyLinesAndComments() {
    TextLines lines = new TextLines("t", new StringReader("# a\n\n \t\n1 2\n  # b\n3\n"), 1);
    assertTrue(lines.nextFields());
    assertEquals("1 2", lines.text());
    assertTrue(lines.nextFields());
    assertEquals("t:6:1", lines.place(0).toString());
    assertFalse(lines.nextFields());
  }

  @Test
  void placesFieldsAtTheirColumnOrLineEnd() {
    TextLines lines = new TextLines("t", new StringReader(" ab\tab  a b"), 3);
    assertTrue(lines.next());
    int[] columns = {2, 5, 9, 11, 12, 12};
    for (int field = 0; field < columns.length; field++) {
      assertEquals("t:3:" + columns[field], lines.place(field).toString());
    }
  }

  @Test
  void errorQuotesTheReasonOfTheSystem() {
    Map<IOException, String> reasons =
        Map.of(
            new FileSystemException("a", null, "too many links"), "too many links",
            new FileSystemException("b"), "b",
            new IOException("no more"), "no more",
            new IOException(), "null");
    reasons.forEach(
        (fault, reason) ->
            assertEquals(
                "t:2:1: cannot be read (" + reason + "), expected a text file",
                TextLines.unreadable("t", 2, fault).getMessage()));
  }

  @Test
  void unpacksFilesByEndingInAnyCase() throws IOException {
    Path file = folder.resolve("A.GZ");
    try (OutputStream out = new GZIPOutputStream(Files.newOutputStream(file))) {
      out.write('x');
    }
    try (TextLines lines = TextLines.open(file)) {
      assertTrue(lines.next());
      assertEquals("x", lines.text());
    }
  }

  @Test
  void errorsNameUnreadableFiles() throws IOException {
    Path missing = folder.resolve("missing");
    Path plain = Files.writeString(folder.resolve("plain.gz"), "no gzip");
    assertFault(missing + ":1:1: no such file, expected a file", missing);
    assertFault(folder + ":1:1: is a folder, expected a file", folder);
    assertFault(plain + ":1:1: cannot be read (Not in GZIP format), expected a text file", plain);
  }

  @Test
  void rejectsLinesAboveAMillionCharacters() {
    String longest = "x".repeat(TextLines.MAX_LINE);
    TextLines lines = new TextLines("t", new StringReader("ab\n" + longest + "\n" + longest), 7);
    for (int line = 7; line < 10; line++) {
      assertTrue(lines.next(), "line " + line);
    }
    assertFalse(lines.next());
    TextLines longer =
        new TextLines("t", new StringReader("ab\n" + longest + "x".repeat(1 << 17)), 7);
    assertTrue(longer.next());
    assertEquals(
        "t:8:1: cannot be read (a line has more than 1048576 characters), expected a text file",
        assertThrows(InputException.class, longer::next).getMessage());
  }

  @Test
  void closeClosesTheFile() {
    boolean[] closed = {false};
    Reader reader =
        new StringReader("x") {
          @Override
          public void close() {
            closed[0] = true;
          }
        };
    new TextLines("t", reader, 1).close();
    assertTrue(closed[0]);
  }

  private static void assertFault(String expected, Path file) {
    assertEquals(
        expected, assertThrows(InputException.class, () -> TextLines.open(file)).getMessage());
  }
}
