package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The sweeps around the defaults, from the command line. */
class SensitivityCommandTest {
  private static final List<String> PARAMETERS =
      List.of("threshold-hifi", "threshold-camsim", "targets", "gamma", "epsilon", "k", "reward");

  @TempDir Path folder;

  @Test
  void sweepsEveryParameterWithItsDefaultAmongTheValues() throws IOException {
    Cli run = Cli.run("sensitivity", "--steps", 60, "--repeat", 2, "--out", folder);
    assertEquals(0, run.exit(), run.err());
    List<String> rows = Files.readAllLines(folder.resolve("sensitivity.csv"));
    for (String parameter : PARAMETERS) {
      assertTrue(
          rows.stream().anyMatch(row -> row.matches(parameter + ",[^,]*,true,all,.*")), parameter);
      assertTrue(Files.size(folder.resolve("sensitivity-" + parameter + ".png")) > 1000);
      assertTrue(Files.size(folder.resolve("sensitivity-" + parameter + ".svg")) > 1000);
    }
    assertTrue(Files.readString(folder.resolve("sensitivity.md")).contains("It holds in"));
  }
}
