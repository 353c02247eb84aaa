package org.hificamsim.parquet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.apache.parquet.column.ColumnDescriptor;
import org.apache.parquet.hadoop.metadata.BlockMetaData;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Rows;
import org.hificamsim.runs.output.RunTables;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tables as files. */
class ParquetRowsTest {
  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(ints = {0, 1, ParquetRows.BATCH - 1, ParquetRows.BATCH, ParquetRows.BATCH + 1})
  void hasAsManyRowsAsWereEnded(int rows) throws IOException {
    Path file = written(rows);
    List<String> read = new ArrayList<>();
    new ParquetFormat().each(file, read::add);
    assertEquals(rows, read.size());
    for (int row = 0; row < rows; row++) {
      assertEquals("0," + row + ",t" + row % 3 + ",0.1,-0.0", read.get(row));
    }
  }

  @Test
  void keepsOneGroupOfRowsInMemoryAtMost() throws IOException {
    int rows = 2 * ParquetRows.MAX_ROWS + 1;
    try (StoredFile file = new StoredFile(written(rows))) {
      assertTrue(file.groups().size() >= 3);
      assertEquals(rows, file.groups().stream().mapToLong(BlockMetaData::getRowCount).sum());
      for (BlockMetaData group : file.groups()) {
        assertTrue(group.getRowCount() <= ParquetRows.MAX_ROWS + ParquetRows.BATCH);
        assertTrue(group.getTotalByteSize() < 1.5 * ParquetRows.MAX_BYTES, group::toString);
      }
    }
  }

  @Test
  void columnsHaveTypesAndSayWhatTheyMean() throws IOException {
    try (StoredFile file = new StoredFile(written(1))) {
      assertEquals(
          List.of(
              "[run] required int32 run",
              "[step] required int64 step",
              "[target] required binary target (STRING)",
              "[x] optional double x",
              "[y] optional double y"),
          file.about().getSchema().getColumns().stream().map(ColumnDescriptor::toString).toList());
      assertEquals("m", file.about().getKeyValueMetaData().get("x.unit"));
      assertEquals("the target's name", file.about().getKeyValueMetaData().get("target.meaning"));
    }
  }

  @Test
  void aMissingValueIsAnEmptyCell() throws IOException {
    Path file = written(1, Double.NaN, Double.POSITIVE_INFINITY);
    new ParquetFormat().each(file, row -> assertEquals("0,0,t0,,Infinity", row));
  }

  @Test
  void withoutACommitNothingIsInThePlaceOfTheFile() throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      Rows rows = new ParquetFormat().create(RunTables.TARGETS, output);
      rows.add(1);
      rows.close();
      rows.close();
      assertFalse(Files.exists(folder.resolve("targets.parquet")));
    }
    assertFalse(Files.exists(folder.resolve("targets.parquet")));
  }

  @Test
  void aCellOfAnotherKindIsRefused() throws IOException {
    try (OutputFolder output = new OutputFolder(folder);
        Rows rows = new ParquetFormat().create(RunTables.TARGETS, output)) {
      assertThrows(IllegalStateException.class, () -> rows.add(0.5));
    }
  }

  /** Whatever a byte says: rows, or a fault of the file's. */
  @Test
  void aFileWithAnotherByteIsReadOrRefused() throws IOException {
    Path file = written(500);
    byte[] right = Files.readAllBytes(file);
    int refused = 0;
    Random random = new Random(1);
    for (int i = 0; i < 1000; i++) {
      byte[] wrong = right.clone();
      wrong[random.nextInt(wrong.length)] = (byte) random.nextInt();
      Files.write(file, wrong);
      try {
        new ParquetFormat().each(file, row -> {});
      } catch (InputException e) {
        refused++;
      }
    }
    assertTrue(refused > 100, refused + " refused");
  }

  private Path written(int count) throws IOException {
    return written(count, 0.1, -0.0);
  }

  private Path written(int count, double x, double y) throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      try (Rows rows = new ParquetFormat().create(RunTables.TARGETS, output)) {
        for (int row = 0; row < count; row++) {
          rows.add(0);
          rows.add(row);
          rows.add("t" + row % 3);
          rows.add(x);
          rows.add(y);
          rows.end();
        }
      }
      output.commit(List.of());
    }
    return folder.resolve("targets.parquet");
  }
}
