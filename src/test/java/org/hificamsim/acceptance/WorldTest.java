package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests commands on a world with optics, walls and cameras that need time to move. */
class WorldTest {
  private static final String WORLD =
      """
<root><simulation min_x="-10" max_x="10" min_y="-8" max_y="8" order="coverage" step="0.5">
<obstacles><wall x1="-4" y1="0" x2="4" y2="0"/><pillar x="6" y="3" radius="0.5"/></obstacles>
<cameras>
<optics name="ptz" pixels="640" hfov="60 30 10" pan="-60:60:30" pan_speed="40" zoom_time="2"/>
<optics name="fixed" hfov="90" pixels="1920"/>
<camera name="a" x="-9" y="-7" heading="45" optics="ptz"/>
<camera name="b" x="9" y="7" heading="225" optics="ptz"/>
<camera name="c" x="0" y="-7.5" heading="0" optics="fixed"/>
</cameras>
<objects>
<object features="1" x="-5" y="3" heading="0" speed="0.4" move="RandomWaypoint"/>
<object features="2" x="5" y="-3" heading="0" speed="0.4" move="RandomWaypoint"/>
<object features="3" x="0" y="5" heading="0" speed="0.4" width="0.5" height="1.7"
    move="RandomWaypoint"/>
</objects></simulation></root>
""";

  @TempDir Path folder;

  @Test
  void sameSeedWritesSameBytes() throws IOException {
    for (String policy : List.of("random", "sarsa", "optimal")) {
      Path first = run(policy, "1");
      Path second = run(policy, "2");
      for (String file : List.of("steps.csv", "zooms.csv", "targets.csv")) {
        assertEquals(Files.readString(first.resolve(file)), Files.readString(second.resolve(file)));
      }
    }
  }

  @Test
  void recordsDirectionOfCameras() throws IOException {
    List<String> rows = Files.readAllLines(run("random", "1").resolve("zooms.csv"));
    assertEquals("run,step,camera,level,radius,detected,pan,viewing_angle,moving", rows.get(0));
    List<String[]> rowsOfTurningCamera =
        rows.stream().map(row -> row.split(",")).filter(row -> row[2].equals("a")).toList();
    assertEquals(40, rowsOfTurningCamera.size());
    for (String[] row : rowsOfTurningCamera) {
      assertTrue(Math.abs(Double.parseDouble(row[6])) <= 60.001, Arrays.toString(row));
      assertTrue(row[8].equals("0") || row[5].equals("0"), "blind on its way");
    }
    assertTrue(rowsOfTurningCamera.stream().anyMatch(row -> row[8].equals("1")));
    assertTrue(rowsOfTurningCamera.stream().anyMatch(row -> row[8].equals("0")));
  }

  @Test
  void camSimsNetworkUsesSameOpticsAndWalls() throws IOException {
    Path own = run("random", "1", "--order", "camsim");
    Path coverage = folder.resolve("coverage");
    Cli run =
        Cli.run(
            "camsim",
            folder.resolve("world.xml").toString(),
            "-t",
            "40",
            "--policy",
            "random",
            "--detection",
            "dori-2014:level=observe",
            "-o",
            folder.resolve("output.csv").toString(),
            "--coverage-out",
            coverage.toString());
    assertEquals(0, run.exit(), run.err());
    assertEquals(
        Files.readString(own.resolve("steps.csv")),
        Files.readString(coverage.resolve("steps.csv")));
  }

  @Test
  void rejectsRangeBanditWithLens() throws IOException {
    Path scenario = Files.writeString(folder.resolve("world.xml"), WORLD);
    Cli run =
        Cli.run(
            "camsim",
            scenario.toString(),
            "-a",
            "BanditZoom",
            "-b",
            "UCB1",
            "-o",
            folder.resolve("output.csv").toString());
    assertEquals(2, run.exit());
    assertEquals(
        "error: "
            + scenario
            + ":6:45: <camera> optics is 'ptz', expected none, or law=\"round\", where the schedule"
            + " is BanditZoom, which sets ranges\n",
        run.err());
  }

  private Path run(String policy, String name, String... options) throws IOException {
    Path scenario = Files.writeString(folder.resolve("world.xml"), WORLD);
    Path out = folder.resolve(policy + name);
    List<Object> words = new ArrayList<>(List.of("run", scenario, "--policy", policy));
    words.addAll(List.of("--detection", "dori-2014:level=observe", "--steps", 40));
    words.addAll(List.of("--record", "--out", out));
    words.addAll(List.of(options));
    Cli run = Cli.run(words.toArray());
    assertEquals(0, run.exit(), run.err());
    return out;
  }
}
