package org.hificamsim.network.files;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.network.statistics.StepFigures;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class StepTableTest {
  private static final StepFigures FIGURES =
      new StepFigures(3, 0.5, 7, 1, 0.25, 9, 12.5, 0.75, 1, 2);

  /** A disk with room for the header only. */
  private static final class FullDisk extends Writer {
    private int room = 100;
    private boolean closed;

    @Override
    public void write(char[] text, int from, int length) throws IOException {
      room -= length;
      if (room < 0) {
        throw new IOException("No space left on device");
      }
    }

    @Override
    public void flush() {}

    @Override
    public void close() {
      closed = true;
    }
  }

  @Test
  void writesOneRowPerStep() throws IOException {
    Writer out = new StringWriter();
    try (StepTable table = new StepTable(out)) {
      table.add(FIGURES);
    }
    assertEquals(
        lines(
            "time;utility;communication;visible;strategy;totUtil;totComm;overlap;confidence;"
                + "proportion",
            "3;0.5;7.0;0;1;0.25;9.0;12.5;0.75;1.0"),
        out.toString());
  }

  private static String lines(String... texts) {
    return Stream.of(texts)
        .map(line -> line + System.lineSeparator())
        .collect(Collectors.joining());
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 100_000})
  void reportsRowThatCannotBeWritten(int rows) {
    FullDisk disk = new FullDisk();
    UncheckedIOException e =
        assertThrows(
            UncheckedIOException.class,
            () -> {
              try (StepTable table = new StepTable(disk)) {
                for (int row = 0; row < rows; row++) {
                  table.add(FIGURES);
                }
              }
            });
    assertEquals("No space left on device", e.getCause().getMessage());
    assertTrue(disk.closed);
  }
}
