package org.hificamsim.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests when runs begin and end, and where their files are. */
class RunsTest {
  private static final Path OTHER = CamSimRun.ROOT.resolve("scenarios/tutorial-camsim.xml");

  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(strings = {"--no-gui", "-x"})
  void consecutiveRunsHaveSeparateFolders(String closing) {
    CamSimRun both =
        start(
            "epics.camwin.Main",
            "policy=random,seed=7,out=results",
            closing,
            "-t",
            "40",
            CamSimRun.CROSSING.toString(),
            OTHER.toString());
    assertEquals("", both.err());
    CamSimRun second =
        CamSimRun.of(folder.resolve("second"), "policy=random,seed=8,out=results", OTHER, 40);
    assertEquals(40, both.rows("results/steps.csv").size());
    assertEquals(
        second.text("results/zooms.csv").replace("\n0,", "\n1,"),
        both.text("results/run-1/zooms.csv"));
    assertTrue(both.text("results/summary.json").contains("\"seed\" : 7"));
    assertTrue(both.text("results/run-1/summary.json").contains("\"seed\" : 8"));
  }

  @Test
  void unclosedRunWritesItsFilesAtExit() {
    CamSimRun open = start("epics.camwin.Main", "out=results", "-x", "-t", "40", "" + OTHER);
    CamSimRun closed = CamSimRun.of(folder.resolve("closed"), "out=results", OTHER, 40);
    assertEquals(closed.text("results/steps.csv"), open.text("results/steps.csv"));
    assertEquals(closed.text("results/summary.json"), open.text("results/summary.json"));
  }

  @Test
  void runStoppedDuringStepKeepsEarlierSteps() throws IOException {
    Path classes =
        Variant.of(folder, "    trade();", "    if (time == 25) System.exit(3);\n    trade();");
    CamSimRun stopped =
        CamSimRun.start(
            folder.resolve("run"),
            "out=results",
            List.of(classes),
            "epics.camwin.Main",
            List.of("-t", "40", OTHER.toString()));
    assertEquals(3, stopped.exit());
    assertEquals(25, stopped.rows("results/steps.csv").size());
    assertTrue(stopped.text("results/summary.json").contains("\"steps\" : 25"));
    try (var files = Files.list(stopped.folder().resolve("results"))) {
      assertEquals(5, files.count()); // with the record of what was written
    }
  }

  @Test
  void runsInSeveralThreadsAreIndependent() throws IOException {
    Path classes =
        Variant.compile(
            folder,
            "Threads.java",
            """
import epics.camsim.core.SimCore;
import java.io.File;
import java.nio.file.Paths;

public class Threads {
  public static void main(String[] files) throws Exception {
    SimCore first = new SimCore(new File(files[0]), 0, Paths.get("first.csv"));
    SimCore second = new SimCore(new File(files[1]), 0, Paths.get("second.csv"));
    first.update();
    Thread other = new Thread(() -> { for (int i = 0; i < 300; i++) second.update(); });
    other.start();
    for (int i = 1; i < 300; i++) first.update();
    other.join();
    first.close_files();
    second.close_files();
  }
}
""");
    CamSimRun both =
        CamSimRun.start(
            folder.resolve("both"),
            "detection=hifi:orb-power,policy=sarsa,out=results",
            List.of(classes, CamSimRun.DOUBLES),
            "Threads",
            List.of(CamSimRun.CROSSING.toString(), OTHER.toString()));
    assertEquals("", both.err());
    CamSimRun first =
        CamSimRun.of(
            folder.resolve("first"),
            "detection=hifi:orb-power,policy=sarsa,out=results",
            CamSimRun.CROSSING,
            300);
    CamSimRun second =
        CamSimRun.of(
            folder.resolve("second"),
            "detection=hifi:orb-power,policy=sarsa,seed=1,out=results",
            OTHER,
            300);
    assertEquals(first.text("results/zooms.csv"), both.text("results/zooms.csv"));
    assertEquals(
        second.text("results/zooms.csv").replace("\n0,", "\n1,"),
        both.text("results/run-1/zooms.csv"));
  }

  @Test
  void coresSteppedInTurnHaveSeparateRuns() throws IOException {
    CamSimRun both =
        runStatements(
            "policy=sarsa,out=results",
            """
            for (int i = 0; i < 100; i++) {
              first.update();
              second.update();
            }
            first.close_files();
            second.close_files();
            """);
    assertEquals("", both.err());
    CamSimRun first =
        CamSimRun.of(folder.resolve("1"), "policy=sarsa,out=results", CamSimRun.CROSSING, 100);
    CamSimRun second =
        CamSimRun.of(folder.resolve("2"), "policy=sarsa,seed=1,out=results", OTHER, 100);
    assertEquals(first.text("looks.csv"), both.text("first/looks.csv"));
    assertEquals(second.text("looks.csv"), both.text("second/looks.csv"));
    assertEquals(100, both.rows("results/steps.csv").size());
    assertEquals(100, both.rows("results/run-1/steps.csv").size());
  }

  @Test
  void simulationContinuedAfterItsEndKeepsItsOwnZoomRanges() throws IOException {
    CamSimRun on =
        runStatements(
            "policy=zoom-in,out=results",
            """
            for (int end = 0; end < 3; end++) {
              for (int i = 0; i < 10; i++) first.update();
              first.close_files();
            }
            """);
    assertEquals("", on.err());
    assertEquals(10, on.rows("results/steps.csv").size());
    assertEquals(
        Set.of(4.0),
        on.rows("first/looks.csv").stream()
            .map(Look::parse)
            .filter(look -> look.camera().equals("A"))
            .map(Look::range)
            .collect(Collectors.toSet()));
  }

  @Test
  void runNumbersHaveNoGaps() throws IOException {
    CamSimRun on =
        runStatements(
            "policy=random,seed=7,out=results",
            """
            first.update();
            first.close_files();
            first.close_files();
            first.update();
            first.close_files();
            second.update();
            second.close_files();
            """);
    assertEquals("", on.err());
    assertTrue(on.text("results/run-1/summary.json").contains("\"seed\" : 8"));
  }

  @Test
  void unexpectedCameraRestartsPolicy() throws IOException {
    Path file = folder.resolve("hidden.scenario"); // the bridge expects names that end in .xml
    Files.copy(CamSimRun.CROSSING, file);
    CamSimRun run =
        CamSimRun.of(folder.resolve("run"), "policy=qb-sarsa:k=1,out=results", file, 100);
    assertEquals(
        "hificamsim-bridge: step 55: more cameras or objects than expected:"
            + " policy qb-sarsa:k=1 starts over\n",
        run.err());
    assertEquals(100, run.rows("results/steps.csv").size());
    assertEquals(
        45, run.rows("results/zooms.csv").stream().filter(row -> row.contains(",E,")).count());
    String summary = run.text("results/summary.json");
    assertTrue(summary.contains("\"scenario\" : \"camsim\""), summary);
    int messages = 2 * (4 * 40 + 3 * 15 + 4 * 45); // a query and an answer for each online camera
    assertTrue(summary.contains("\"messages\" : " + messages + ",\n"), summary);
  }

  @Test
  void scenarioIsFoundBehindLongClassPath() {
    List<Path> classPath = new ArrayList<>(Collections.nCopies(500, Path.of("libraries/none.jar")));
    classPath.add(CamSimRun.DOUBLES);
    CamSimRun run =
        CamSimRun.start(
            folder.resolve("run"),
            "out=results",
            classPath,
            "epics.camwin.Main",
            List.of("-t", "5", OTHER.toString()));
    String summary = run.text("results/summary.json");
    assertTrue(summary.contains("\"scenario\" : \"tutorial-camsim\""), summary);
  }

  /** Runs statements that use two cores, {@code first} and {@code second}. */
  private CamSimRun runStatements(String options, String statements) throws IOException {
    String main =
        """
        import epics.camsim.core.SimCore;
        import java.io.File;
        import java.nio.file.*;

        public class Steps {
          public static void main(String[] files) throws Exception {
            SimCore first = core(files[0], "first");
            SimCore second = core(files[1], "second");
            STATEMENTS
          }

          private static SimCore core(String file, String folder) throws Exception {
            Path output = Files.createDirectories(Paths.get(folder)).resolve("output.csv");
            return new SimCore(new File(file), 0, output);
          }
        }
        """;
    Path classes = Variant.compile(folder, "Steps.java", main.replace("STATEMENTS", statements));
    return CamSimRun.start(
        folder.resolve("steps"),
        options,
        List.of(classes, CamSimRun.DOUBLES),
        "Steps",
        List.of(CamSimRun.CROSSING.toString(), OTHER.toString()));
  }

  private CamSimRun start(String main, String options, String... arguments) {
    return CamSimRun.start(
        folder.resolve("run"), options, List.of(CamSimRun.DOUBLES), main, List.of(arguments));
  }
}
