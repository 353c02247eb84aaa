package org.hificamsim.core;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NearestTest {
  private static final List<String> COMMANDS =
      List.of("compare", "validate", "list", "run", "view", "report", "camsim");

  @ParameterizedTest
  @CsvSource({
    "rnu, run",
    "lst, list",
    "viewer, view",
    "comapre, compare",
    "sim, camsim",
    "'', run"
  })
  void listsIntendedNameFirst(String text, String expected) {
    String names = Nearest.to(text, COMMANDS);
    assertTrue(names.startsWith(expected + ", "), names);
    assertTrue(names.endsWith(", ... (7 in all)"), names);
    assertEquals(6, names.split(", ").length, names);
  }

  @Test
  void listsFewNamesInTheirOrder() {
    assertEquals("view, run", Nearest.to("rnu", List.of("view", "run")));
    assertEquals("a, b, c, d, e", Nearest.to("e", List.of("a", "b", "c", "d", "e")));
  }

  @Test
  void countsSwappedLettersAsOneMistake() {
    List<String> names = List.of("rat", "run", "to", "tap", "lists", "views");
    assertTrue(Nearest.to("rnu", names).startsWith("run, rat, "));
    assertTrue(Nearest.to("ot", names).startsWith("to, "));
  }

  @Test
  void acceptsTextOfAnyLength() {
    assertTrue(Nearest.to("x".repeat(1_000_000), COMMANDS).contains("(7 in all)"));
  }
}
