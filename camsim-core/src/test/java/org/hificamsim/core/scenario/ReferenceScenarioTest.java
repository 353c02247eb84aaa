package org.hificamsim.core.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.Reference;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests that every scenario file of the reference data loads, and is equal after writing and
 * reading.
 */
class ReferenceScenarioTest {
  @TempDir Path folder;

  @TestFactory
  Stream<DynamicTest> ownScenariosSurviveWritingAndReading() {
    return roundTrips(32, "own-camsim", "own-coverage");
  }

  @TestFactory
  Stream<DynamicTest> publishedScenariosSurviveWritingAndReading() {
    return roundTrips(49 + 11, "camsim/scenarios", "coverage-study");
  }

  private Stream<DynamicTest> roundTrips(int count, String... folders) {
    List<Path> files =
        Stream.of(folders).flatMap(name -> Reference.scenarios(name).stream()).toList();
    assertEquals(count, files.size());
    return files.stream().map(file -> dynamicTest(file.toString(), () -> roundTrip(file)));
  }

  private void roundTrip(Path file) throws IOException {
    Scenario read = ScenarioReader.read(file, anyMovement -> true, new ArrayList<>()::add);
    Path written = folder.resolve(file.getFileName());
    Files.writeString(written, ScenarioWriter.write(read));
    assertEquals(read, ScenarioReader.read(written, anyMovement -> true, new ArrayList<>()::add));
  }
}
