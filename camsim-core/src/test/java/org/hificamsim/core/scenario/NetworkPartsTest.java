package org.hificamsim.core.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class NetworkPartsTest {
  @TempDir Path folder;

  @Test
  void isEmptyWithoutNetworkSettings() throws IOException {
    assertEquals(List.of(), parts("", ""));
  }

  @ParameterizedTest
  @ValueSource(strings = {"ai_algorithm='A'", "comm='2'", "customcom='C'", "limit='3'"})
  void listsAttributeOfOneCamera(String attribute) throws IOException {
    String name = attribute.substring(0, attribute.indexOf('='));
    assertEquals(List.of(name), parts(attribute, ""));
    String event = "<event timestep='3' participant='camera' event='add' name='b' x='0' y='0'";
    assertEquals(
        List.of(name),
        parts("", event + " heading='0' viewing_angle='90' range='5' " + attribute + "/>"));
  }

  @Test
  void listsAllPartsInOrder() throws IOException {
    assertEquals(
        List.of("ai_algorithm", "bandit", "visiongraph", "grc events"),
        parts(
            "ai_algorithm='A' bandit='B'",
            "<event timestep='3' participant='grc' event='error' duration='2'/><visiongraph"
                + " static='true'><graphnode name='a'><neighbour name='c'/></graphnode>"
                + "</visiongraph>"));
  }

  private List<String> parts(String attributes, String elements) throws IOException {
    String scenario =
        "<root><simulation min_x='-9' max_x='9' min_y='-9' max_y='9'><camera name='a' x='0' y='0'"
            + " heading='0' viewing_angle='90' range='5' %s/><object features='1' x='0' y='0'"
            + " heading='0' speed='0'/>%s</simulation></root>";
    Path file = folder.resolve("test.xml");
    Files.writeString(file, scenario.formatted(attributes, elements));
    return ScenarioReader.read(file, movement -> true, warning -> {}).networkParts();
  }
}
