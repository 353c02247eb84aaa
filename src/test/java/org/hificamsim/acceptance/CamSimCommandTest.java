package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests {@code camsim}: the command line and files of CamSim, and our additions. */
class CamSimCommandTest {
  private static final Path SCENARIO = Cli.scenario("tutorial-camsim");
  private static final String HEADER =
      "time;utility;communication;visible;strategy;totUtil;totComm;overlap;confidence;proportion";

  @TempDir Path folder;

  private Cli camsim(String options, Path scenario) {
    List<Object> words = new ArrayList<>(List.of("camsim"));
    if (!options.isBlank()) {
      words.addAll(List.of(options.strip().split("\\s+")));
    }
    words.addAll(List.of("-o", folder.resolve("o.csv"), scenario));
    return Cli.run(words.toArray());
  }

  private List<String> lines(String file) throws IOException {
    return Files.readAllLines(folder.resolve(file));
  }

  @Test
  void writesCamSimTableAndSummary() throws IOException {
    Cli run = camsim("-t 30 -s 4 --no-gui", SCENARIO);
    assertEquals(0, run.exit(), run.err());
    List<String> rows = lines("o.csv");
    assertEquals(HEADER, rows.get(0));
    assertEquals(31, rows.size());
    assertTrue(rows.get(30).startsWith("29;"), rows.get(30));
    assertTrue(lines("summary.csv").get(0).startsWith("SEED,TIME,GLOBAL_UTILITY,"));
    assertTrue(lines("summary.csv").get(1).startsWith("4,30,0.0,"));
    camsim("-t 10", SCENARIO);
    assertEquals(3, lines("summary.csv").size(), "one header, two runs");
  }

  @Test
  void exportsTracksAsEventsForCamSim() throws IOException {
    Files.writeString(
        folder.resolve("one.tracks"), "tracks 1\ninterval 1\ntarget 7 size 1\n2 3 4\n5 5\n");
    Path tracked = folder.resolve("one.xml");
    Files.writeString(
        tracked,
        """
        <root><simulation min_x="0" max_x="30" min_y="0" max_y="40">
        <optics name="dome" law="pinhole" pixels="640" hfov="60 20" pan="0"/>
        <camera name="a" x="1" y="1" heading="0" optics="dome" ai_algorithm="Active" comm="0"/>
        <tracks file="one.tracks"/></simulation></root>
        """);
    Path written = folder.resolve("for/camsim.xml");
    Cli run = camsim("--for-camsim " + written, tracked);
    assertEquals(0, run.exit(), run.err());
    assertEquals(written + "\n", run.out());
    String text = Files.readString(written);
    assertTrue(text.contains("viewing_angle=\"60.0\" range=\"50.0\""), text);
    assertTrue(text.contains("timestep=\"0\" participant=\"camera\" event=\"change\" name=\"a\""));
    assertTrue(
        text.contains(
            "timestep=\"2\" participant=\"object\" event=\"add\" name=\"7.0\" x=\"3.0\""
                + " y=\"4.0\" heading=\"0.0\" speed=\"0.0\""),
        text);
    assertTrue(text.contains("timestep=\"4\" participant=\"object\" event=\"error\" name=\"7.0\""));
    assertFalse(text.contains("tracks"), text);
    assertFalse(Files.exists(folder.resolve("o.csv")));
  }

  @Test
  void leavesOnlyItsFiles() throws IOException {
    camsim("-t 5", SCENARIO);
    try (Stream<Path> files = Files.list(folder)) {
      assertEquals(
          List.of("o.csv", "summary.csv"),
          files.map(file -> file.getFileName().toString()).sorted().toList());
    }
  }

  @Test
  void onlyRunWarnsThatNetworkIsNotSimulated() {
    assertFalse(camsim("-t 5", SCENARIO).err().contains("not simulated"));
    Cli run = Cli.run("run", SCENARIO, "--steps", 5, "--out", folder);
    assertTrue(run.err().contains("not simulated"), run.err());
  }

  @Test
  void usesSummaryFileAndParameters() throws IOException {
    Path parameters = folder.resolve("p.properties");
    Files.writeString(parameters, "epsilon = 0.9\nINTERVAL=3\nHistEnabled=false\n");
    String options = "-a active -b EpsilonGreedy -t 200 -f " + folder.resolve("sums.csv");
    camsim(options, SCENARIO);
    List<String> plain = lines("o.csv");
    assertEquals(2, lines("sums.csv").size());
    camsim(options + " -p " + parameters, SCENARIO);
    assertNotEquals(plain, lines("o.csv"));
    assertFalse(Files.exists(folder.resolve("summary.csv")));
  }

  @Test
  void coverageTablesDoNotChangeCamSimTable() throws IOException {
    camsim("-t 40 -a active -c 0", SCENARIO);
    List<String> plain = lines("o.csv");
    Path coverage = folder.resolve("coverage");
    Cli run = camsim("-t 40 -a active -c 0 --coverage-out " + coverage, SCENARIO);
    assertEquals(0, run.exit(), run.err());
    assertEquals(plain, lines("o.csv"));
    assertEquals(41, Files.readAllLines(coverage.resolve("steps.csv")).size());
    assertTrue(Files.exists(coverage.resolve("summary.json")));
  }

  @Test
  void detectionModelChangesResults() throws IOException {
    camsim("-t 50 -a active -c 0", SCENARIO);
    List<String> plain = lines("o.csv");
    Cli run = camsim("-t 50 -a active -c 0 --detection hifi:orb-lin", SCENARIO);
    assertEquals(0, run.exit(), run.err());
    assertNotEquals(plain, lines("o.csv"));
  }

  @Test
  void runsCoverageScenarioWithOrWithoutPolicy() throws IOException {
    Path lattice = Cli.scenario("lattice-random");
    assertEquals(0, camsim("-t 20 -a active -c 0", lattice).exit());
    List<String> plain = lines("o.csv");
    Cli zooming = camsim("-t 20 -a active -c 0 --policy zoom-in", lattice);
    assertEquals(0, zooming.exit(), zooming.err());
    assertNotEquals(plain, lines("o.csv"));
    Cli both = camsim("-t 20 -a BanditZoom -b UCB1 -c 0 --policy zoom-in", lattice);
    assertEquals(2, both.exit());
    assertTrue(both.err().contains(": zoom: expected none, or no --policy, where"), both.err());
  }

  @Test
  void sameCommandWritesSameBytes() throws IOException {
    String options = "-t 100 -a HistActive -c 1 -e 5 -s 3";
    camsim(options, SCENARIO);
    List<String> first = lines("o.csv");
    camsim(options, SCENARIO);
    assertEquals(first, lines("o.csv"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "-t -1 | -t is -1, expected a whole number from 0",
        "-s 4294967296 | '4294967296'",
        "-v 3 | -v is 3, expected one of -1, 0, 1, 2",
        "-c 5 | -c is 5, expected a whole number from 0 to 4",
        "-c 4 | -u is '', expected one of Broadcast",
        "-c 4 -u Whisper | -u is 'Whisper', expected one of Broadcast, Smooth, Step",
        "-a epics.ai.Nobody | -a is 'epics.ai.Nobody', expected one of Active",
        "-b Gambler | -b is 'Gambler', expected one of EpsilonGreedy",
        "-a BanditZoom | <camera> has no bandit, expected one of EpsilonGreedy",
        "-m epics.movement.Teleport | unknown movement",
        "-m Scripted | -m 'Scripted': object 1.0 has no waypoints, expected at least two for",
        "-m Tracks | -m 'Tracks': object 1.0 has no track, expected one of <tracks> for movement",
        "-p missing.properties | missing.properties: cannot be read",
        "--quirks Q99 | names 'Q99'",
        "--detection nobody | unknown detection 'nobody'",
        "--policy nobody | unknown policy 'nobody'",
        "--threshold 2 | threshold is 2.0",
        "-f /no/such/folder/s.csv | summary file",
      })
  void rejectsWrongUsageWithoutOutput(String options, String expected) throws IOException {
    Cli run = camsim(options, SCENARIO);
    assertEquals(2, run.exit(), run.err());
    List<String> errors = run.err().lines().filter(line -> !line.startsWith("warning")).toList();
    assertEquals(1, errors.size(), run.err());
    assertTrue(errors.get(0).startsWith("error: ") && errors.get(0).contains(expected), run.err());
    try (Stream<Path> files = Files.list(folder)) {
      assertEquals(0, files.count());
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "-f DIR/o.csv | -o and -f are one file",
        "-f DIR/./o.csv | -o and -f are one file",
        "--coverage-out DIR/o.csv | -o and --coverage-out are one file",
        "-f DIR/c/steps.csv --coverage-out DIR/c | -f and --coverage-out are one file",
        "-f DIR/in.xml | what the command reads and -f are one file",
        "--for-camsim DIR/in.xml | what the command reads and --for-camsim are one file",
      })
  void rejectsSameFileForTwoPurposes(String options, String expected) throws IOException {
    Path scenario = Files.copy(SCENARIO, folder.resolve("in.xml"));
    Cli run = camsim("-t 5 " + options.replace("DIR", folder + ""), scenario);
    assertEquals(2, run.exit(), run.err());
    assertTrue(run.err().contains("error: " + expected + ", '" + folder), run.err());
    assertEquals(-1, Files.mismatch(SCENARIO, scenario));
    try (Stream<Path> files = Files.list(folder)) {
      assertEquals(List.of(scenario), files.toList());
    }
  }

  @Test
  void rejectsLinkToScenarioAsOutput() throws IOException {
    Path scenario = Files.copy(SCENARIO, folder.resolve("in.xml"));
    Path link = Files.createSymbolicLink(folder.resolve("link.csv"), scenario);
    Cli run = camsim("-t 5 -f " + link, scenario);
    assertEquals(2, run.exit(), run.err());
    assertTrue(run.err().contains("error: what the command reads and -f are one file"), run.err());
    assertEquals(-1, Files.mismatch(SCENARIO, scenario));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "ai_algorithm='epics.Nobody' | 1:152: <camera> ai_algorithm is 'epics.Nobody', expected",
        "ai_algorithm='BanditZoom' | 1:81: <camera> has no bandit, expected one of EpsilonGreedy",
        "bandit='Gambler' | 1:152: <camera> bandit is 'Gambler', expected one of EpsilonGreedy",
        "comm='4' customcom='Whisper' | 1:161: <camera> customcom is 'Whisper', expected one of",
        "comm='4' | 1:81: <camera> has no customcom, expected one of Broadcast",
      })
  void errorsOfNetworkNamesHaveTheirPlace(String camera, String expected) throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("odd.xml"),
            "<root><simulation min_x='0' max_x='9' min_y='0' max_y='9'></simulation><cameras>"
                + "<camera name='A' x='1' y='1' heading='0' viewing_angle='360' range='5' "
                + camera
                + "/></cameras><objects><object features='1' x='1' y='2' heading='0' speed='0'/>"
                + "</objects></root>");
    for (Cli run : List.of(camsim("-t 5", file), Cli.run("validate", file))) {
      assertEquals(2, run.exit(), run.err());
      assertTrue(run.err().startsWith("error: " + file + ":" + expected), run.err());
    }
    assertEquals(0, camsim("-t 5 -a Active -b UCB1 -c 0", file).exit(), "options say otherwise");
  }

  @Test
  void rejectsEventWithMovementWithoutWaypoints() throws IOException {
    assertMovementOfEventRejected("Waypoints", "no waypoints, expected at least two");
  }

  @ParameterizedTest
  @ValueSource(strings = {"Tracks", "epics.movement.Tracks"})
  void acceptsShortAndLongNameOfTracks(String movement) {
    Cli run = camsim("-t 5 -m " + movement, Cli.scenario("passage"));
    assertEquals(0, run.exit(), run.err());
  }

  @Test
  void rejectsEventWithMovementWithoutTrack() throws IOException {
    assertMovementOfEventRejected("Tracks", "no track, expected one of <tracks>");
  }

  private void assertMovementOfEventRejected(String movement, String missing) throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("odd.xml"),
            "<root><simulation min_x='0' max_x='9' min_y='0' max_y='9'></simulation><cameras>"
                + "<camera name='A' x='1' y='1' heading='0' viewing_angle='360' range='5'/>"
                + "</cameras><events><event timestep='2' participant='object' event='add' name='1'"
                + " x='1' y='2' heading='0' speed='0' move='epics.movement."
                + movement
                + "'/></events></root>");
    assertEquals(0, camsim("-t 5", file).exit(), "ignored as in CamSim");
    Cli run = camsim("-t 5 --quirks none", file);
    assertEquals(2, run.exit(), run.err());
    String expected = "object 1.0 has " + missing + " for movement " + movement;
    assertTrue(run.err().contains("error: " + file + ": " + expected), run.err());
  }

  @Test
  void rejectsUnknownKeyInParameterFile() throws IOException {
    Path parameters = Files.writeString(folder.resolve("p.properties"), "Speed=1\n");
    Cli run = camsim("-p " + parameters, SCENARIO);
    assertEquals(2, run.exit());
    assertTrue(run.err().contains("unknown option 'Speed=1', expected one of "), run.err());
  }

  @Test
  void requiresExactlyOneScenario() {
    assertEquals(2, Cli.run("camsim").exit());
    assertEquals(2, Cli.run("camsim", SCENARIO, SCENARIO).exit());
    assertEquals(0, Cli.run("camsim", "-h").exit());
  }
}
