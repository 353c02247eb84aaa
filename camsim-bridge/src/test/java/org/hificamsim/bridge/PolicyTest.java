package org.hificamsim.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** How policies set the ranges of CamSim's cameras. */
class PolicyTest {
  private static final List<Double> RADII = List.of(3.0, 7.5, 14.0, 24.0);
  private static final String ZOOMS = "zooms=3;7.5;14;24";

  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "fixed:0;1;2;3;1",
        "random",
        "optimal",
        "one-hop",
        "epsilon-greedy:epsilon=0.2",
        "ucb1",
        "sarsa:gamma=0.9;epsilon=0.1",
        "qb-sarsa:k=2"
      })
  void decidesAsInOurOwnEngineWhileCamerasAndObjectsComeAndGo(String policy) throws IOException {
    CamSimRun with =
        run("with", "detection=hifi:orb-power,policy=" + policy + "," + ZOOMS + ",out=results");
    assertEquals("", with.err());
    Path expected = folder.resolve("engine");
    Engine.record(
        expected,
        CamSimRun.CROSSING,
        RADII,
        Engine.detection("hifi:orb-power"),
        policy.replace(';', ','),
        200);
    for (String file : List.of("steps.csv", "zooms.csv", "targets.csv")) {
      assertEquals(Files.readString(expected.resolve(file)), with.text("results/" + file), file);
    }
  }

  @Test
  void withoutAModelItIsRewardedFromWhatCamSimSees() throws IOException {
    CamSimRun with = run("with", "policy=epsilon-greedy," + ZOOMS + ",out=results");
    Path expected = folder.resolve("engine");
    Engine.record(
        expected,
        CamSimRun.CROSSING,
        RADII,
        Engine.detection("camsim-visibility"),
        "epsilon-greedy",
        200);
    assertEquals(Files.readString(expected.resolve("zooms.csv")), with.text("results/zooms.csv"));
  }

  @Test
  void setsTheRangesBeforeTheStepsLooksTwentyMetresAndMoreIncluded() {
    CamSimRun with = run("with", "policy=random," + ZOOMS + ",out=results");
    Map<String, Double> radii = new HashMap<>();
    for (String row : with.rows("results/zooms.csv")) {
      String[] cells = row.split(",");
      radii.put(cells[1] + " " + cells[2], Double.valueOf(cells[4]));
    }
    Set<Double> ranges = new TreeSet<>();
    for (String row : with.rows("looks.csv")) {
      Look look = Look.of(row);
      assertEquals(radii.get(look.step() + " " + look.camera()), look.range(), row);
      ranges.add(look.range());
    }
    assertEquals(Set.copyOf(RADII), Set.copyOf(ranges));
  }

  @Test
  void levelsAreFiveUpToEachCamerasOwnRangeWhereNoneAreGiven() {
    CamSimRun with = run("with", "policy=random");
    Map<String, Set<Double>> ranges =
        with.rows("looks.csv").stream()
            .map(Look::of)
            .collect(
                Collectors.groupingBy(
                    Look::camera, Collectors.mapping(Look::range, Collectors.toSet())));
    assertEquals(Set.of(4.0, 6.0, 8.0, 10.0, 12.0), ranges.get("A"));
    assertEquals(Set.of(16 / 3.0, 8.0, 32 / 3.0, 40 / 3.0, 16.0), ranges.get("B"));
    assertEquals(Set.of(3.0, 4.5, 6.0, 7.5, 9.0), ranges.get("C"));
  }

  @Test
  void theSeedDecides() {
    String first = run("first", "policy=random").text("looks.csv");
    assertEquals(first, run("again", "policy=random,seed=0").text("looks.csv"));
    assertTrue(!first.equals(run("other", "policy=random,seed=1").text("looks.csv")));
  }

  @Test
  void aPolicyThatDoesNotSuitTheCamerasLeavesCamSimAsItIs() {
    CamSimRun with = run("with", "policy=fixed:0;1");
    assertEquals(run("without", CamSimRun.WITHOUT_AGENT).all(), with.all());
    assertEquals(
        "hificamsim-bridge: policy fixed: levels has 2 values, expected 1 for all cameras or 5,"
            + " one for each; CamSim runs on unchanged\n",
        with.err());
  }

  @Test
  void levelsOneByOneSuitTheCamerasThatAreThere() {
    Path scenario = CamSimRun.ROOT.resolve("scenarios/lattice-random.xml");
    CamSimRun with =
        CamSimRun.of(folder.resolve("with"), "policy=fixed:0;1;2;3;4;3;2;1;0", scenario, 20);
    assertEquals("", with.err());
    Map<String, Set<Double>> ranges =
        with.rows("looks.csv").stream()
            .map(Look::of)
            .collect(
                Collectors.groupingBy(
                    Look::camera, Collectors.mapping(Look::range, Collectors.toSet())));
    assertEquals(Set.of(2.5), ranges.get("Cam_01"));
    assertEquals(Set.of(7.5), ranges.get("Cam_05"));
    assertEquals(Set.of(3.75), ranges.get("Cam_08"));
  }

  private CamSimRun run(String name, String options) {
    return CamSimRun.of(folder.resolve(name), options);
  }
}
