package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests that broken files and commands are accepted, or rejected in error lines with the place and
 * expectation, without a stack trace and without changing inputs. The cases are the same each time,
 * in addition to the corpus; {@code gradle fuzz} tries any number of new ones ({@link Fuzz}).
 */
class FuzzTest {
  @ParameterizedTest
  @CsvSource({
    "SCENARIO, 80",
    "MODEL, 50",
    "MEASUREMENTS, 20",
    "DATASET, 20",
    "TRACKS, 30",
    "RECORDING, 80",
    "WALLS, 40",
    "JOURNAL, 10",
    "SHARD, 10",
    "RESULTS, 20",
    "PHOTO, 5",
    "COMMAND, 30"
  })
  void acceptsOrRejectsMutants(FuzzKind kind, int mutants) {
    Fuzz fuzz = new Fuzz(kind, mutants, 1);
    fuzz.run();
    assertEquals(List.of(), fuzz.wrong(), fuzz::toString);
  }

  @TestFactory
  Stream<DynamicTest> acceptsOrRejectsCorpus() {
    return Arrays.stream(FuzzKind.values())
        .filter(kind -> kind != FuzzKind.ONNX && kind != FuzzKind.SQLITE) // not on this class path
        .flatMap(
            kind ->
                kind.corpus().stream()
                    .map(
                        file ->
                            DynamicTest.dynamicTest(
                                kind + " " + file.getFileName(),
                                () ->
                                    FuzzCase.check(
                                        kind,
                                        file.getFileName().toString(),
                                        Files.readAllBytes(file)))));
  }
}
