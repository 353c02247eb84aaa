package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.Reference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The commands {@code validate} and {@code list}. */
class ValidateAndListTest {
  @TempDir Path folder;

  @Test
  void everyScenarioOfTheProjectIsValidWithoutAWarningButForTheNetwork() throws IOException {
    try (Stream<Path> files = Files.list(Cli.ROOT.resolve("scenarios"))) {
      for (Path file : files.filter(path -> path.toString().endsWith(".xml")).sorted().toList()) {
        Cli validate = Cli.run("validate", file);
        assertEquals(0, validate.exit(), validate.err());
        assertTrue(validate.out().startsWith(file + ": ok, "), validate.out());
        assertTrue(
            validate.err().lines().allMatch(line -> line.contains("CamSim's network")),
            validate.err());
      }
    }
  }

  @Test
  void everyReferenceFileOfOursIsValidAndRuns() {
    List<Path> scenarios =
        Stream.of("own-camsim", "own-coverage")
            .flatMap(name -> Reference.scenarios(name).stream())
            .toList();
    assertEquals(30, scenarios.size());
    scenarios.forEach(file -> Cli.assertValidAndRuns(file, folder));
  }

  @Test
  void oneBadFileAmongGoodOnesGivesExitCode2AndTheOthersAreStillChecked() throws IOException {
    Path bad = Files.writeString(folder.resolve("bad.xml"), "<root/>");
    Cli validate =
        Cli.run("validate", bad, Cli.scenario("lattice-random"), Cli.scenario("ring-random"));
    assertEquals(2, validate.exit());
    assertEquals(2, validate.out().lines().count());
    assertTrue(validate.err().startsWith("error: " + bad + ":1:1: "), validate.err());
  }

  @ParameterizedTest
  @ValueSource(strings = {"hifi:orb-lin", "camsim-range", "hifi-literal", "geometric"})
  void listsDetections(String name) {
    Cli list = Cli.run("list", "detections");
    assertEquals(0, list.exit());
    assertTrue(list.out().lines().anyMatch(line -> line.startsWith(name + " ")), list.out());
  }

  @Test
  void listsPoliciesWithTheirOptions() {
    Cli list = Cli.run("list", "policies");
    assertEquals(0, list.exit());
    assertTrue(list.out().contains("epsilon-greedy"), list.out());
    assertTrue(list.out().contains("    epsilon=0.1"), list.out());
  }

  @Test
  void listsScenarios() {
    Cli list = Cli.run("list", "scenarios");
    assertEquals(0, list.exit(), list.err());
    Cli.SIX.forEach(name -> assertTrue(list.out().contains(name + ".xml"), name));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "run",
        "compare",
        "validate",
        "list",
        "list detections",
        "list policies",
        "list scenarios"
      })
  void everyCommandHasHelp(String words) {
    Cli help = Cli.run((Object[]) (words + " --help").split(" "));
    assertEquals(0, help.exit(), help.err());
    assertTrue(help.out().startsWith("Usage: hificamsim " + words), help.out());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "rnu x.xml | unknown command 'rnu', expected one of run, ",
        "list detction | unknown command 'detction', expected one of detections, policies,"
            + " scenarios",
        "profile | expected lab, measure, fit",
        "run --stepz 3 | Unknown option: '--stepz', maybe --steps",
      })
  void aMisspelledWordIsToldWhatWasMeant(String words, String expected) {
    Cli wrong = Cli.run((Object[]) words.split(" "));
    assertEquals(2, wrong.exit());
    assertEquals(1, wrong.err().lines().count(), wrong.err());
    assertTrue(wrong.err().contains(expected), wrong.err());
  }

  @Test
  void helpAndACompletionScriptAreCommands() {
    assertTrue(Cli.run("help", "run").out().startsWith("Usage: hificamsim run "));
    assertTrue(Cli.run("generate-completion").out().startsWith("#!/usr/bin/env bash"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "list", "walk", "list nothing", "run"})
  void wrongCommandsAreOneErrorLineAndExitCode2(String words) {
    Cli wrong = words.isEmpty() ? Cli.run() : Cli.run((Object[]) words.split(" "));
    assertEquals(2, wrong.exit());
    assertEquals(1, wrong.err().lines().count(), wrong.err());
    assertTrue(wrong.err().startsWith("error: "), wrong.err());
  }
}
