package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Every declaration that users look up is on one page of the documentation. */
class ReferenceTest {
  private static final Pattern MARK = Pattern.compile("(?m)^<!-- reference: (.+) -->$");

  @Test
  void everyPartIsOnOnePage() throws IOException {
    try (Stream<Path> pages = Files.list(Cli.ROOT.resolve("docs"))) {
      List<String> marked =
          pages
              .filter(page -> page.toString().endsWith(".md"))
              .flatMap(ReferenceTest::marks)
              .sorted()
              .toList();
      assertEquals(List.copyOf(Reference.parts().keySet()), marked);
    }
  }

  @Test
  void everyPartHasContent() {
    for (Map.Entry<String, String> part : Reference.parts().entrySet()) {
      assertFalse(part.getValue().lines().count() < 3, part.toString());
    }
  }

  private static Stream<String> marks(Path page) {
    return MARK.matcher(Cli.text(page)).results().map(mark -> mark.group(1));
  }
}
