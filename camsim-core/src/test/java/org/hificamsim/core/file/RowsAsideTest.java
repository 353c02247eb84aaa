package org.hificamsim.core.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Rows written by a thread of their own. */
class RowsAsideTest {
  /** A disk that is full after so many rows. */
  private static final class Full implements Rows {
    private int rows;
    private boolean closed;

    private Full(int rows) {
      this.rows = rows;
    }

    @Override
    public void add(long number) {}

    @Override
    public void add(double number) {}

    @Override
    public void end() {
      if (rows-- == 0) {
        throw new UncheckedIOException(new IOException("No space left on device"));
      }
    }

    @Override
    public void close() {
      closed = true;
    }
  }

  @Test
  void writesWhatTheRowsThemselvesWrite() throws IOException {
    for (int rows : new int[] {0, 1, CellBatch.CELLS / 4, 3 * CellBatch.CELLS}) {
      assertEquals(written(rows, false), written(rows, true), rows + " rows");
    }
  }

  private static String written(int count, boolean aside) throws IOException {
    Writer text = new StringWriter();
    NumberRows plain = new NumberRows(text, "a,b,c", ',', "\n");
    try (Rows rows = aside ? new RowsAside(plain) : plain) {
      SplittableRandom random = new SplittableRandom(5);
      for (int row = 0; row < count; row++) {
        rows.add(random.nextLong());
        rows.add(row % 7 == 0 ? Double.NaN : random.nextDouble());
        rows.add(row);
        rows.end();
      }
    }
    return text.toString();
  }

  @Test
  void whoAddsRowsLearnsThatTheyCannotBeWritten() {
    Full full = new Full(10);
    RowsAside rows = new RowsAside(full);
    UncheckedIOException e =
        assertThrows(UncheckedIOException.class, () -> add(rows, 3 * CellBatch.CELLS));
    assertTrue(e.getMessage().contains("No space left"), e.getMessage());
    assertFalse(full.closed);
    assertThrows(UncheckedIOException.class, rows::close);
    assertTrue(full.closed);
  }

  @Test
  void inATryWithResourcesTheFailureIsReported() {
    UncheckedIOException e =
        assertThrows(
            UncheckedIOException.class,
            () -> {
              try (RowsAside rows = new RowsAside(new Full(10))) {
                add(rows, 3 * CellBatch.CELLS);
              }
            });
    assertTrue(e.getMessage().contains("No space left"), e.getMessage());
    assertEquals(1, e.getSuppressed().length);
  }

  @Test
  void theEndTellsOfTheLastRowsToo() {
    Full full = new Full(2);
    RowsAside rows = new RowsAside(full);
    add(rows, 3);
    assertThrows(UncheckedIOException.class, rows::close);
    assertTrue(full.closed);
    rows.close();
  }

  private static void add(Rows rows, int count) {
    for (int row = 0; row < count; row++) {
      rows.add(row);
      rows.end();
    }
  }
}
