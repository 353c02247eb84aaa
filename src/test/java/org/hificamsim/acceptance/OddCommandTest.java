package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A run as an ODD protocol. */
class OddCommandTest {
  @TempDir Path folder;

  @Test
  void hasTheSevenElementsInTheirOrder() {
    List<String> headings =
        text("lattice-random").lines().filter(line -> line.startsWith("## ")).toList();
    assertEquals(
        List.of(
            "## 1 Purpose and patterns",
            "## 2 Entities, state variables, and scales",
            "## 3 Process overview and scheduling",
            "## 4 Design concepts",
            "## 5 Initialization",
            "## 6 Input data",
            "## 7 Submodels"),
        headings);
  }

  @Test
  void saysWhatTheScenarioAndTheOptionsSay() {
    String text = text("cluster-random", "--policy", "sarsa:gamma=0.5", "--seed", 3, "--repeat", 4);
    assertTrue(text.contains("| `epsilon` | 0.1 |"), text);
    assertTrue(text.contains("`sarsa:gamma=0.5`"));
    assertTrue(text.contains("Runs: 4, seeds 3 to 6."));
    assertTrue(text.contains("`Straight`"));
    assertTrue(text.contains("6. Every target moves"));
    assertTrue(text.contains("| Cam_01 | "), text);
    String camsim = text("cluster-random", "--order", "camsim");
    assertTrue(camsim.indexOf("Every target moves") < camsim.indexOf("All cameras choose"));
  }

  @Test
  void theStepsOfAStepAreNumberedWithoutAGap() {
    for (String order : List.of("camsim", "coverage")) {
      List<String> numbers =
          text("ring-random", "--order", order)
              .lines()
              .filter(line -> line.matches("\\d\\. .*"))
              .map(line -> line.substring(0, 1))
              .toList();
      assertEquals(List.of("1", "2", "3", "4", "5", "6"), numbers);
    }
  }

  @Test
  void asksItsAuthorForWhatNoFileSays() {
    long asked =
        text("ring-random").lines().filter(line -> line.contains("*To be written by")).count();
    assertTrue(asked >= 4, asked + " requests");
  }

  @Test
  void goesToAFile() throws IOException {
    Path out = folder.resolve("odd.md");
    Cli odd = Cli.run("odd", Cli.scenario("tutorial-camsim"), "--out", out);
    assertEquals(new Cli(0, "", odd.err()), odd);
    assertEquals(text("tutorial-camsim"), Files.readString(out));
    assertFalse(Files.readString(out).toLowerCase(Locale.ROOT).contains("null"));
  }

  @Test
  void aWrongOptionIsReported() {
    Cli odd = Cli.run("odd", Cli.scenario("ring-random"), "--policy", "walk");
    assertEquals(2, odd.exit());
    assertTrue(odd.err().contains("unknown policy 'walk'"), odd.err());
  }

  private static String text(String scenario, Object... more) {
    Object[] words = new Object[more.length + 2];
    words[0] = "odd";
    words[1] = Cli.scenario(scenario);
    System.arraycopy(more, 0, words, 2, more.length);
    Cli odd = Cli.run(words);
    assertEquals(0, odd.exit(), odd.err());
    return odd.out();
  }
}
