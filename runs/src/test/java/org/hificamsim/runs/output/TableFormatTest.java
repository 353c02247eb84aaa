package org.hificamsim.runs.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class TableFormatTest {
  @TempDir Path folder;

  @Test
  void rejectsUnknownFormat() {
    assertRejects(
        "format is 'arrow', expected one of csv, parquet", () -> TableFormat.named("arrow"));
  }

  @Test
  void reportsFormatWhoseModuleIsMissing() {
    assertRejects(
        "format 'parquet' is not on the class path, expected its jars in CLASSPATH, or csv",
        () -> TableFormat.named("parquet"));
  }

  @Test
  void readsOnlyCsv() throws IOException {
    Path file = Files.createFile(folder.resolve("steps.parquet"));
    assertRejects(
        "'" + file + "' is not read here, expected a run with format=csv",
        () -> StepRow.forEachRow(folder, row -> {}));
  }

  private static void assertRejects(String message, Executable call) {
    assertEquals(message, assertThrows(InputException.class, call).getMessage());
  }

  @ParameterizedTest
  @MethodSource("tablesOfRuns")
  void everyColumnHasNameAndMeaning(Table<?> table) {
    List<String> names = table.columns().stream().map(Column::name).toList();
    assertFalse(names.isEmpty());
    assertEquals(names.size(), Set.copyOf(names).size());
    table.columns().forEach(column -> assertFalse(column.meaning().isEmpty(), column::name));
  }

  private static List<Table<?>> tablesOfRuns() {
    return List.of(RunTables.STEPS_BY_CHANCE, RunTables.VIEWS, RunTables.TARGETS_BY_CHANCE);
  }
}
