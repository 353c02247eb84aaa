package org.hificamsim.acceptance;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/**
 * Whatever is done to a right file or command, it is taken or refused in error lines that say where
 * and what was expected: no exception, no stack trace. These are 310 cases that are the same each
 * time, and the corpus; {@code gradle fuzz} tries 13,000 new ones ({@link Fuzz}).
 */
class FuzzTest {
  private static final List<String> PIECES =
      List.of(
          "",
          "0",
          "-1",
          "-0.0",
          "NaN",
          "Infinity",
          "1e999",
          "-1e308",
          "4.9e-324",
          "1e9",
          "0x10",
          "99999999999999999999",
          "2147483648",
          "\u0000",
          "\u001b[2J",
          "\u2028",
          "\u00e9",
          "\ufeff",
          "<",
          "<a>",
          "</root>",
          "<!--",
          "]]>",
          "&amp;",
          "&x;",
          "<zoom>",
          "<camera/>",
          "<!DOCTYPE a>",
          "\"",
          "'",
          "=",
          ",",
          ",,",
          ":",
          "@",
          ";",
          "\n",
          "\r\n",
          " ",
          "{",
          "}",
          "[",
          "]",
          "[[1]]",
          "null",
          "true",
          "\\u0000",
          "--seed",
          "--json",
          "--strict",
          "--record",
          "--quiet",
          "--help",
          "--threshold",
          "a=b",
          "x".repeat(9999));

  @Property(tries = 80, seed = "1")
  void scenarios(@ForAll("brokenScenarios") FuzzCase broken) {
    broken.check();
  }

  @Property(tries = 50, seed = "2")
  void models(@ForAll("brokenModels") FuzzCase broken) {
    broken.check();
  }

  @Property(tries = 20, seed = "3")
  void measurements(@ForAll("brokenMeasurements") FuzzCase broken) {
    broken.check();
  }

  @Property(tries = 20, seed = "4")
  void datasets(@ForAll("brokenDatasets") FuzzCase broken) {
    broken.check();
  }

  @Property(tries = 30, seed = "6")
  void tracks(@ForAll("brokenTracks") FuzzCase broken) {
    broken.check();
  }

  @Property(tries = 80, seed = "7")
  void recordings(@ForAll("brokenRecordings") FuzzCase broken) {
    broken.check();
  }

  @Property(tries = 30, seed = "5")
  void commands(@ForAll("brokenCommands") FuzzCase broken) {
    broken.check();
  }

  @TestFactory
  Stream<DynamicTest> everyFileOfTheCorpus() {
    return Arrays.stream(FuzzKind.values())
        .flatMap(
            kind ->
                kind.corpus().stream()
                    .map(
                        file ->
                            DynamicTest.dynamicTest(
                                kind + " " + file.getFileName(),
                                () -> FuzzCase.check(kind, Files.readAllBytes(file)))));
  }

  @Provide
  Arbitrary<FuzzCase> brokenScenarios() {
    return broken(FuzzKind.SCENARIO);
  }

  @Provide
  Arbitrary<FuzzCase> brokenModels() {
    return broken(FuzzKind.MODEL);
  }

  @Provide
  Arbitrary<FuzzCase> brokenMeasurements() {
    return broken(FuzzKind.MEASUREMENTS);
  }

  @Provide
  Arbitrary<FuzzCase> brokenDatasets() {
    return broken(FuzzKind.DATASET);
  }

  @Provide
  Arbitrary<FuzzCase> brokenTracks() {
    return broken(FuzzKind.TRACKS);
  }

  @Provide
  Arbitrary<FuzzCase> brokenRecordings() {
    return broken(FuzzKind.RECORDING);
  }

  @Provide
  Arbitrary<FuzzCase> brokenCommands() {
    return broken(FuzzKind.COMMAND);
  }

  private static Arbitrary<FuzzCase> broken(FuzzKind kind) {
    return Combinators.combine(
            Arbitraries.of(kind.corpus()), edit().list().ofMinSize(1).ofMaxSize(4))
        .as((seed, edits) -> new FuzzCase(kind, seed, edits));
  }

  private static Arbitrary<FuzzEdit> edit() {
    return Combinators.combine(
            Arbitraries.of(FuzzEdit.Kind.class),
            Arbitraries.integers().between(0, 9999),
            Arbitraries.integers().between(1, 40),
            Arbitraries.of(PIECES).map(FuzzTest::asBytes))
        .as((what, at, length, piece) -> new FuzzEdit(what, at / 10_000.0, length, piece));
  }

  /** The piece's bytes in UTF-8, a character for each. */
  private static String asBytes(String piece) {
    return new String(piece.getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1);
  }
}
