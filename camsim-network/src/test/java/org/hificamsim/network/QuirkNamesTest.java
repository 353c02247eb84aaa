package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.hificamsim.core.Spelling;
import org.junit.jupiter.api.Test;

/** Tests the names of quirks that users and documents use. */
class QuirkNamesTest {
  private static final Path DOCS =
      Path.of(System.getProperty("hificamsim.root", "..")).resolve("docs");

  @Test
  void findsQuirkByNameOrNumber() {
    assertEquals(Optional.of(Quirk.TIES_BY_HASH_CODE), Quirk.find("ties-by-hash-code"));
    assertEquals(Optional.of(Quirk.TIES_BY_HASH_CODE), Quirk.find("Q19"));
    assertEquals(Optional.of(Quirk.WAYPOINT_SPEED_IS_HEADING), Quirk.find("q3"));
    assertEquals(Optional.empty(), Quirk.find("Q1"));
  }

  @Test
  void documentsNameAllOptionalQuirks() throws IOException {
    Set<String> expected = new TreeSet<>();
    for (Quirk quirk : Quirk.values()) {
      expected.add(Spelling.of(quirk));
    }
    String network = Files.readString(DOCS.resolve("camsim-network.md"));
    String behaviour = Files.readString(DOCS.resolve("camsim-behaviour.md"));
    assertEquals(expected, names(network, "(?m)^\\| `([a-z-]+)` \\(Q"));
    assertEquals(expected, names(behaviour, "\\| option `([a-z-]+)`"));
  }

  private static Set<String> names(String text, String pattern) {
    return Pattern.compile(pattern)
        .matcher(text)
        .results()
        .map(name -> name.group(1))
        .collect(Collectors.toCollection(TreeSet::new));
  }
}
