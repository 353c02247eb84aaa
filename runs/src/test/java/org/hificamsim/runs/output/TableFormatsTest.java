package org.hificamsim.runs.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class TableFormatsTest {
  @TempDir Path folder;

  @Test
  void anUnknownFormatIsRefusedWithThoseThereAre() {
    assertRefused(
        "--format is 'arrow', expected one of csv, parquet", () -> TableFormats.named("arrow"));
  }

  @Test
  void aFormatWhoseModuleIsMissingSaysWhatToDo() throws IOException {
    assertRefused(
        "format 'parquet' is not on the class path, expected its jars in CLASSPATH, or csv",
        () -> TableFormats.named("parquet"));
    Path file = Files.createFile(folder.resolve("steps.parquet"));
    assertRefused(
        file
            + ": format 'parquet' is not on the class path, expected its jars in CLASSPATH, or the"
            + " files of a run with --format csv",
        () -> StepRow.each(folder, row -> {}));
  }

  private static void assertRefused(String message, Executable act) {
    assertEquals(message, assertThrows(InputException.class, act).getMessage());
  }

  @ParameterizedTest
  @EnumSource(
      names = {
        "RUN_STEPS",
        "RUN_STEPS_BY_CHANCE",
        "RUN_ZOOMS",
        "RUN_VIEWS",
        "RUN_TARGETS",
        "RUN_TARGETS_BY_CHANCE"
      })
  void everyColumnOfARunIsExplained(Table table) {
    List<StepColumn> columns = table.stepColumns();
    assertFalse(columns.isEmpty());
    assertEquals(columns.size(), EnumSet.copyOf(columns).size());
    columns.forEach(column -> assertFalse(column.meaning().isEmpty(), column::label));
  }
}
