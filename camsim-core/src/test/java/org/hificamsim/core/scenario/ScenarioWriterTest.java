package org.hificamsim.core.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.metrics.Objective;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ScenarioWriterTest {
  @TempDir Path folder;

  @Test
  void everyElementReadsBackEqual() throws IOException {
    Scenario scenario = read(ScenarioReaderTest.everything());
    String written = ScenarioWriter.write(scenario);
    assertEquals(scenario, read(written));
    assertEquals(written, ScenarioWriter.write(read(written)), "and written the same again");
  }

  @Test
  void scenarioMadeInCodeReadsBackEqual() throws IOException {
    Scenario scenario =
        new TestScenario()
            .camera(TestScenario.camera("tab\there\r\n<&>\"'", 0.1 + 0.2, -1e-300, 1e22, 360, 5))
            .target(Math.nextUp(1.0), Double.MIN_VALUE, 30, 1.0 / 3)
            .scenario();
    assertEquals(scenario.cameras(), read(ScenarioWriter.write(scenario)).cameras());
    assertEquals(scenario.targets(), read(ScenarioWriter.write(scenario)).targets());
  }

  @Test
  void detectionRuleReadsBackWithOptions() throws IOException {
    for (String rule : List.of("chance:alpha=0.01,memory=5,phantoms=on", "probability")) {
      Scenario scenario =
          new TestScenario()
              .camera(0, 0)
              .target(0, 0)
              .scenario()
              .withDetect(DetectionRule.parse(rule));
      assertEquals(rule, read(ScenarioWriter.write(scenario)).detect().orElseThrow().text());
    }
  }

  @Test
  void errorOfInvalidDetectionRuleNamesPlace() {
    String file = ScenarioWriter.write(new TestScenario().camera(0, 0).target(0, 0).scenario());
    String unknown = file.replace("order=", "detect=\"luck\" order=");
    InputException fault = assertThrows(InputException.class, () -> read(unknown));
    assertTrue(fault.getMessage().contains("test.xml:3:"), fault.getMessage());
    assertTrue(
        fault.getMessage().contains("unknown detection rule 'luck', expected"), fault.getMessage());
    String both = file.replace("order=", "detect=\"chance\" threshold=\"0.4\" order=");
    fault = assertThrows(InputException.class, () -> read(both));
    assertTrue(
        fault
            .getMessage()
            .endsWith("threshold is '0.4', expected none together with detect=\"chance\""),
        fault.getMessage());
  }

  @Test
  void writesObjectiveUnlessItIsTheDefault() throws IOException {
    Scenario scenario = new TestScenario().camera(0, 0).target(0, 0).scenario();
    assertFalse(ScenarioWriter.write(scenario).contains("objective"));
    for (String text : List.of("covered:k=2", "lexicographic", "sum:cap=4", "kmin")) {
      Scenario scored = scenario.with(Scenario.OBJECTIVE, Objective.parse(text));
      assertEquals(text, read(ScenarioWriter.write(scored)).objective().text());
    }
  }

  @Test
  void errorOfInvalidObjectiveNamesPlace() {
    String file = ScenarioWriter.write(new TestScenario().camera(0, 0).target(0, 0).scenario());
    String unknown = file.replace("order=", "objective=\"most\" order=");
    InputException fault = assertThrows(InputException.class, () -> read(unknown));
    assertTrue(fault.getMessage().contains("test.xml:3:"), fault.getMessage());
    assertTrue(fault.getMessage().contains("unknown objective 'most', expected one of"));
  }

  @Test
  void writesDeclarationAndIndentation() {
    String written = ScenarioWriter.write(new TestScenario().camera(0, 0).target(0, 0).scenario());
    assertTrue(written.startsWith("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<root>\n  <simul"));
    assertTrue(written.endsWith("\n</root>\n"), written);
  }

  private Scenario read(String text) throws IOException {
    Path file = Files.writeString(folder.resolve("test.xml"), text);
    return ScenarioReader.read(file, movement -> true, new ArrayList<>()::add);
  }
}
