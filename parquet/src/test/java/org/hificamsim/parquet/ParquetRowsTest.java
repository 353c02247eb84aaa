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

class ParquetRowsTest {
  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(ints = {0, 1, ParquetRows.BATCH - 1, ParquetRows.BATCH, ParquetRows.BATCH + 1})
  void writesEveryRow(int rows) throws IOException {
    Path file = write(rows);
    List<String> read = new ArrayList<>();
    StoredFile.forEachRow(file, read::add);
    assertEquals(rows, read.size());
    for (int row = 0; row < rows; row++) {
      assertEquals("0," + row + ",t" + row % 3 + ",0.1,-0.0", read.get(row));
    }
  }

  @Test
  void endsGroupOfRowsBeforeItIsTooLarge() throws IOException {
    int rows = 2 * ParquetRows.MAX_ROWS + 1;
    try (StoredFile file = new StoredFile(write(rows))) {
      assertTrue(file.groups().size() >= 3);
      assertEquals(rows, file.groups().stream().mapToLong(BlockMetaData::getRowCount).sum());
      for (BlockMetaData group : file.groups()) {
        assertTrue(group.getRowCount() <= ParquetRows.MAX_ROWS + ParquetRows.BATCH);
        assertTrue(group.getTotalByteSize() < 1.5 * ParquetRows.MAX_BYTES, group::toString);
      }
    }
  }

  @Test
  void columnsHaveTypesUnitsAndMeanings() throws IOException {
    try (StoredFile file = new StoredFile(write(1))) {
      assertEquals(
          List.of(
              "[run] required int32 run",
              "[step] required int64 step",
              "[target] required binary target (STRING)",
              "[x] optional double x",
              "[y] optional double y"),
          file.metadata().getSchema().getColumns().stream()
              .map(ColumnDescriptor::toString)
              .toList());
      assertEquals("m", file.metadata().getKeyValueMetaData().get("x.unit"));
      assertEquals(
          "the target's name", file.metadata().getKeyValueMetaData().get("target.meaning"));
    }
  }

  @Test
  void writesNanAsMissingValue() throws IOException {
    Path file = write(1, Double.NaN, Double.POSITIVE_INFINITY);
    StoredFile.forEachRow(file, row -> assertEquals("0,0,t0,,Infinity", row));
  }

  @Test
  void fileAppearsOnlyAfterCommit() throws IOException {
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
  void rejectsCellOfAnotherKind() throws IOException {
    try (OutputFolder output = new OutputFolder(folder);
        Rows rows = new ParquetFormat().create(RunTables.TARGETS, output)) {
      assertThrows(IllegalStateException.class, () -> rows.add(0.5));
    }
  }

  @Test
  void readsOrRejectsFileWithChangedByte() throws IOException {
    Path file = write(500);
    byte[] right = Files.readAllBytes(file);
    int refused = 0;
    Random random = new Random(1);
    for (int i = 0; i < 1000; i++) {
      byte[] wrong = right.clone();
      wrong[random.nextInt(wrong.length)] = (byte) random.nextInt();
      Files.write(file, wrong);
      try {
        StoredFile.forEachRow(file, row -> {});
      } catch (InputException e) {
        refused++;
      }
    }
    assertTrue(refused > 100, refused + " refused");
  }

  private Path write(int count) throws IOException {
    return write(count, 0.1, -0.0);
  }

  private Path write(int count, double x, double y) throws IOException {
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
