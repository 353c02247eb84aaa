package org.hificamsim.core.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.core.scenario.declaration.Element;
import org.junit.jupiter.api.Test;

/** Tests that the schema file agrees with the declarations. */
class ScenarioFormatTest {
  private static final Path PROJECT = Path.of(System.getProperty("hificamsim.root"));

  @Test
  void schemaFileIsUpToDate() throws IOException {
    assertEquals(
        ScenarioSchema.text(),
        Files.readString(ScenarioFormat.schema(PROJECT)),
        "camsim.xsd is out of date; maybe run 'gradle scenarioFormat'");
  }

  @Test
  void everyElementHasSummary() {
    for (Element<?> element : ScenarioElements.all()) {
      assertTrue(AttributeDoc.summary(element).endsWith("."), element.name());
    }
  }
}
