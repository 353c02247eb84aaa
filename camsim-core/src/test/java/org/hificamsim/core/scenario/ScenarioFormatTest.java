package org.hificamsim.core.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** The schema and the tables of the documentation are those of the declarations. */
class ScenarioFormatTest {
  private static final Path PROJECT = Path.of(System.getProperty("hificamsim.root"));

  @Test
  void theFilesSayWhatTheReaderDeclares() throws IOException {
    for (Map.Entry<Path, String> file : ScenarioFormat.files(PROJECT).entrySet()) {
      assertEquals(
          file.getValue(),
          Files.readString(file.getKey()),
          file.getKey().getFileName() + " is out of date; maybe run 'gradle scenarioFormat'");
    }
  }

  @Test
  void everyElementSaysWhatItIs() {
    for (Element<?> element : Scenario.elements()) {
      assertTrue(AttributeDoc.summary(element).endsWith("."), element.name());
    }
  }
}
