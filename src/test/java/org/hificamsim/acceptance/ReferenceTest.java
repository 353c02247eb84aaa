package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Tests that the documentation has every declaration that users look up, and has it once. */
class ReferenceTest {
  private static final Map<String, String> PARTS = Reference.parts();

  @Test
  void everyPartIsOnOnePage() throws IOException {
    List<String> names = new ArrayList<>();
    for (Path page : Reference.pages(Cli.ROOT.resolve("docs"))) {
      names.addAll(Reference.names(Cli.text(page)));
    }
    assertEquals(List.copyOf(PARTS.keySet()), names.stream().sorted().toList());
  }

  @Test
  void everyPageHasCurrentTables() throws IOException {
    for (Path page : Reference.pages(Cli.ROOT.resolve("docs"))) {
      String text = Cli.text(page);
      assertEquals(
          Reference.updated(text, PARTS),
          text,
          page + " is stale; to update it, run gradle reference");
    }
  }

  @Test
  void everyPartHasContent() {
    for (Map.Entry<String, String> part : PARTS.entrySet()) {
      assertFalse(part.getValue().lines().count() < 3, part.toString());
    }
  }

  @Test
  void replacesTextBetweenMarks() {
    String page = "a\n<!-- reference: x -->\nold\n<!-- end of reference -->\nb\n";
    String expected = "a\n<!-- reference: x -->\n\nnew\n\n<!-- end of reference -->\nb\n";
    assertEquals(expected, Reference.updated(page, Map.of("x", "new\n")));
    assertEquals(expected, Reference.updated(expected, Map.of("x", "new\n")));
  }

  @Test
  void rejectsPageWhosePartIsUnknownOrDoesNotEnd() {
    Map<String, String> parts = Map.of("x", "new\n");
    assertThrows(
        IllegalArgumentException.class,
        () -> Reference.updated("<!-- reference: y -->\n<!-- end of reference -->\n", parts));
    assertThrows(
        IllegalArgumentException.class,
        () -> Reference.updated("<!-- reference: x -->\nold\n", parts));
  }
}
