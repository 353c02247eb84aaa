package org.hificamsim.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.engine.RunCoverage;
import org.hificamsim.core.policy.ProvingZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests how policies set the ranges of CamSim's cameras. */
class PolicyTest {
  private static final List<Double> RADII = List.of(3.0, 7.5, 14.0, 24.0);
  private static final String ZOOMS = "zooms=3;7.5;14;24";
  private static final String LENS = "law=constant-area,hfov=40;80;160,pan=-90;0;90";

  private static final String DENSE =
      """
<root>
  <simulation min_x='-7' max_x='7' min_y='-7' max_y='7'>
    <cameras>%s</cameras>
    <objects>%s</objects>
    <events>
      <event timestep='5' participant='camera' event='add' name='late' x='0' y='0' heading='0'
          viewing_angle='360' range='9' comm='0'/>
    </events>
  </simulation>
</root>
""";

  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(
      strings = {"fixed:0;1;2;3;1", "random", "optimal", "one-hop", "ucb1", "qb-sarsa:k=2"})
  void policyDecidesAsInHiFiCamSimWhileCamerasAndObjectsChange(String policy) throws IOException {
    CamSimRun with =
        run("with", "detection=hifi:orb-power,policy=" + policy + "," + ZOOMS + ",out=results");
    assertEquals("", with.err());
    Path expected = folder.resolve("engine");
    OwnSimulation.record(
        expected,
        CamSimRun.CROSSING,
        RADII,
        OwnSimulation.detection("hifi:orb-power"),
        policy.replace(';', ','),
        200);
    for (String file : List.of("steps.csv", "zooms.csv", "targets.csv")) {
      assertEquals(Files.readString(expected.resolve(file)), with.text("results/" + file), file);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"chance", "chance:alpha=0.2;memory=4;phantoms=on", "probability"})
  void detectionByChanceDrawsSameNumbersAsInHiFiCamSim(String rule) throws IOException {
    CamSimRun with =
        run(
            "with",
            "detection=hifi:orb-power,detect=" + rule + ",policy=sarsa," + ZOOMS + ",out=results");
    assertEquals("", with.err());
    Path expected = folder.resolve("engine");
    Detection detection =
        Detection.by(
            DetectionRule.parse(rule.replace(';', ',')),
            "hifi:orb-power@" + rule,
            OwnSimulation.CATALOGUE.detection("hifi:orb-power"));
    OwnSimulation.record(expected, CamSimRun.CROSSING, RADII, detection, "sarsa", 200);
    for (String file : List.of("steps.csv", "zooms.csv", "targets.csv")) {
      assertEquals(Files.readString(expected.resolve(file)), with.text("results/" + file), file);
    }
    assertTrue(with.text("results/summary.json").contains("\"hifi:orb-power@" + rule + "\""));
  }

  @ParameterizedTest
  @ValueSource(strings = {"dense.xml", "so-that-the-policy-starts-over.scenario"})
  void summaryReportsUnprovenStepsOfOptimum(String name) throws IOException {
    Path file = Files.writeString(folder.resolve(name), dense());
    String options = "detection=geometric,policy=one-hop:nodes=0," + LENS + ",out=results";
    CamSimRun with = CamSimRun.of(folder.resolve("with"), options, file, 10);
    assertEquals(!name.equals("dense.xml"), with.err().contains("starts over"), with.err());
    ProvingZoomPolicy policy =
        (ProvingZoomPolicy) OwnSimulation.CATALOGUE.policies().create("one-hop:nodes=0");
    Detection detection = OwnSimulation.detection("geometric");
    OpticsSpec optics =
        BridgeOptions.parse(options, OwnSimulation.CATALOGUE).optics().orElseThrow();
    Scenario own = OwnSimulation.scenario(file, optics);
    RunCoverage coverage =
        OwnSimulation.record(folder.resolve("engine"), own, detection, policy, 10);
    assertTrue(policy.unprovenSteps() > 5, policy.unprovenSteps() + " steps");
    assertEquals(
        List.of(
            "\"unproven_steps\" : " + policy.unprovenSteps(),
            "\"performance_bound\" : " + (coverage.performance() + (long) policy.gap())),
        proof(with));
  }

  /**
   * Returns a scenario with so many close cameras, one of which comes later, that a search without
   * nodes cannot prove an optimum. No object is at a camera or on the border of a sector, since
   * CamSim's sectors do not include these places.
   */
  private static String dense() {
    StringBuilder cameras = new StringBuilder();
    StringBuilder objects = new StringBuilder();
    for (int i = 0; i < 60; i++) {
      cameras.append(
          String.format(
              Locale.ROOT,
              "<camera name='c%d' x='%d' y='%d' heading='%d' viewing_angle='360' range='9'"
                  + " ai_algorithm='Active' comm='0'/>\n",
              i,
              i * 5 % 13 - 6,
              i * 7 % 11 - 5,
              i * 37 % 360));
    }
    for (int i = 0; i < 30; i++) {
      objects.append(
          String.format(
              Locale.ROOT,
              "<object features='%d.5' x='%d.25' y='%d.125' heading='0' speed='0'/>\n",
              i + 1,
              i * 3 % 11 - 5,
              i * 8 % 13 - 6));
    }
    return DENSE.formatted(cameras, objects);
  }

  private static List<String> proof(CamSimRun run) {
    return Pattern.compile("\"(unproven_steps|performance_bound)\" : \\d+")
        .matcher(run.text("results/summary.json"))
        .results()
        .map(MatchResult::group)
        .toList();
  }

  @Test
  void rewardsFollowCamSimSightingsWithoutModel() throws IOException {
    CamSimRun with = run("with", "policy=epsilon-greedy," + ZOOMS + ",out=results");
    Path expected = folder.resolve("engine");
    OwnSimulation.record(
        expected,
        CamSimRun.CROSSING,
        RADII,
        OwnSimulation.detection("camsim-visibility"),
        "epsilon-greedy",
        200);
    assertEquals(Files.readString(expected.resolve("zooms.csv")), with.text("results/zooms.csv"));
  }

  @Test
  void rangesAreSetBeforeLookingEvenBeyondTwentyMetres() {
    CamSimRun with = run("with", "policy=random," + ZOOMS + ",out=results");
    Map<String, Double> radii = new HashMap<>();
    for (String row : with.rows("results/zooms.csv")) {
      String[] cells = row.split(",");
      radii.put(cells[1] + " " + cells[2], Double.valueOf(cells[4]));
    }
    Set<Double> ranges = new TreeSet<>();
    for (String row : with.rows("looks.csv")) {
      Look look = Look.parse(row);
      assertEquals(radii.get(look.step() + " " + look.camera()), look.range(), row);
      ranges.add(look.range());
    }
    assertEquals(Set.copyOf(RADII), Set.copyOf(ranges));
  }

  @Test
  void camerasHaveFiveLevelsUpToTheirRangeByDefault() {
    CamSimRun with = CamSimRun.shared("policy=random,out=results");
    Map<String, Set<Double>> ranges =
        with.rows("looks.csv").stream()
            .map(Look::parse)
            .collect(
                Collectors.groupingBy(
                    Look::camera, Collectors.mapping(Look::range, Collectors.toSet())));
    assertEquals(Set.of(4.0, 6.0, 8.0, 10.0, 12.0), ranges.get("A"));
    assertEquals(Set.of(16 / 3.0, 8.0, 32 / 3.0, 40 / 3.0, 16.0), ranges.get("B"));
    assertEquals(Set.of(3.0, 4.5, 6.0, 7.5, 9.0), ranges.get("C"));
  }

  @Test
  void seedDeterminesRun() {
    String first = CamSimRun.shared("policy=random,out=results").text("looks.csv");
    assertEquals(first, run("again", "policy=random,seed=0").text("looks.csv"));
    assertTrue(!first.equals(run("other", "policy=random,seed=1").text("looks.csv")));
  }

  @Test
  void unsuitablePolicyLeavesCamSimUnchanged() {
    CamSimRun with = run("with", "policy=fixed:0;1");
    assertEquals(CamSimRun.shared(CamSimRun.WITHOUT_AGENT).all(), with.all());
    assertEquals(
        "hificamsim-bridge: policy fixed: levels has 2 values, expected 1 for all cameras or 5,"
            + " one for each; CamSim runs on unchanged\n",
        with.err());
  }

  @Test
  void explicitLevelsSetRangesOfPresentCameras() {
    Path scenario = CamSimRun.ROOT.resolve("scenarios/lattice-random.xml");
    CamSimRun with =
        CamSimRun.of(folder.resolve("with"), "policy=fixed:0;1;2;3;4;3;2;1;0", scenario, 20);
    assertEquals("", with.err());
    Map<String, Set<Double>> ranges =
        with.rows("looks.csv").stream()
            .map(Look::parse)
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
