package org.hificamsim.core.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.Reference;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/** Every published scenario file loads and survives writing and reading. */
class ReferenceScenarioTest {
  @TempDir Path folder;

  @TestFactory
  Stream<DynamicTest> everyPublishedFileLoadsAndIsEqualAfterWritingIt() {
    return Stream.of("camsim", "coverage-study")
        .flatMap(part -> Reference.scenarios(part).stream())
        .map(file -> dynamicTest(file.toString(), () -> roundTrip(file)));
  }

  @Test
  void allFilesAreThere() {
    List<Path> camsim = Reference.scenarios("camsim/scenarios");
    assumeFalse(camsim.isEmpty(), "no reference data: skipped");
    assertEquals(49, camsim.size());
    assertEquals(11, Reference.scenarios("coverage-study").size());
  }

  private void roundTrip(Path file) throws IOException {
    Scenario read = ScenarioReader.read(file, anyMovement -> true, new ArrayList<>()::add);
    Path written = folder.resolve(file.getFileName());
    Files.writeString(written, ScenarioWriter.write(read));
    assertEquals(read, ScenarioReader.read(written, anyMovement -> true, new ArrayList<>()::add));
  }
}
