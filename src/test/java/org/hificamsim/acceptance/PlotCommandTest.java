package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** k_min over time from the folders of runs. */
class PlotCommandTest {
  @TempDir Path folder;

  @Test
  void labelsRunsByWhatTheyDifferIn() throws IOException {
    Path svg = folder.resolve("plot.svg");
    Cli plot = Cli.run("plot", run("zoom-out"), run("sarsa"), "--out", svg);
    assertEquals(0, plot.exit(), plot.err());
    String text = Files.readString(svg);
    assertTrue(text.contains(">zoom-out<") && text.contains(">sarsa<"));
    assertTrue(text.contains("ring-random, hifi:orb-lin"));
  }

  @Test
  void aFolderThatIsNoRunIsReportedInOneLine() {
    Cli plot = Cli.run("plot", folder, "--out", folder.resolve("plot.png"));
    assertEquals(2, plot.exit());
    assertTrue(plot.err().contains("summary.json"), plot.err());
    assertEquals(1, plot.err().lines().count());
  }

  @Test
  void onlyPngAndSvgAreWritten() {
    Cli plot = Cli.run("plot", run("zoom-out"), "--out", folder.resolve("plot.gif"));
    assertEquals(2, plot.exit());
    assertTrue(plot.err().contains(".png, .svg or .pdf"), plot.err());
  }

  @Test
  void aBrokenRowIsToldWithItsPlace() throws IOException {
    Path run = run("zoom-out");
    Files.writeString(run.resolve("steps.csv"), "run,step,k_min\n0,99999999,1\n");
    Cli plot = Cli.run("plot", run, "--out", folder.resolve("plot.png"));
    assertEquals(2, plot.exit());
    assertTrue(plot.err().contains("steps.csv:2:3"), plot.err());
  }

  private Path run(String policy) {
    Path out = folder.resolve(policy);
    Cli run =
        Cli.run(
            "run",
            Cli.scenario("ring-random"),
            "--policy",
            policy,
            "--steps",
            300,
            "--repeat",
            2,
            "--out",
            out);
    assertEquals(0, run.exit(), run.err());
    return out;
  }
}
