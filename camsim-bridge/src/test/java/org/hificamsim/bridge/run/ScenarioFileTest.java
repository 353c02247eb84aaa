package org.hificamsim.bridge.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ScenarioFileTest {
  private static final String TEXT =
      """
      <root><simulation channel="loss=0.2">
        <cameras><camera name="A"/><camera name="B"/></cameras>
        <objects><object/><object_with_waypoints><waypoint/></object_with_waypoints></objects>
        <events>
          <event participant="camera" event="add" name="C"/>
          <event participant="camera" event="error" name="A"/>
          <event participant="object" event="add" name="3.0"/>
          <event participant="object" event="error" name="3.0"/>
        </events>
      </simulation></root>
      """;

  @TempDir Path folder;

  @Test
  void countsCamerasAndObjectsOfEvents() throws IOException {
    ScenarioFile scenario = read(TEXT);
    assertEquals(
        new ScenarioFile("some", List.of("A", "B"), 3, 3, Map.of("channel", "loss=0.2")), scenario);
  }

  @Test
  void findsScenarioOfRunByNamesOfItsCameras() throws IOException {
    ScenarioFile scenario = read(TEXT);
    assertTrue(scenario.mayStartWith(List.of("A", "B")));
    assertTrue(
        scenario.mayStartWith(List.of("A", "B", "C")), "added by an event of the first step");
    assertTrue(scenario.mayStartWith(List.of("", "B")), "a camera that is offline has no name");
    assertTrue(!scenario.mayStartWith(List.of("A")));
    assertTrue(!scenario.mayStartWith(List.of("A", "X")));
    assertTrue(!scenario.mayStartWith(List.of("A", "B", "C", "D")));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "no XML",
        "<root><camera name=\"A\">",
        "<!DOCTYPE r [<!ENTITY e 'x'>]><r>&e;</r>"
      })
  void ignoresFileThatIsNoScenario(String text) throws IOException {
    Files.writeString(folder.resolve("some.xml"), text);
    assertEquals(0, ScenarioFile.read(folder.resolve("some.xml")).count());
    assertEquals(0, ScenarioFile.read(folder.resolve("none.xml")).count());
  }

  private ScenarioFile read(String text) throws IOException {
    Path file = Files.writeString(folder.resolve("some.xml"), text);
    return ScenarioFile.read(file).findFirst().orElseThrow();
  }
}
