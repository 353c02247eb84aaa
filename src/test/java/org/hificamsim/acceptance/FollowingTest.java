package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Behaviour;
import org.hificamsim.core.engine.Cooperation;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.ProcessingBudget;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests commands by which targets are followed, or processing budgets limit cameras. */
class FollowingTest {
  private static final Path RING = Cli.ROOT.resolve("scenarios/ring-random.xml");

  private static final String LOSSES =
      "return hificamsim.run.holders.flatMap(list => list.filter((holder, i) =>"
          + " holder < 0 && list[i - 1] >= 0)).length";
  private static final String HANDOVERS =
      "return hificamsim.run.holders.flatMap(list => list.filter((holder, i) =>"
          + " holder >= 0 && list[i - 1] >= 0 && list[i - 1] !== holder)).length";

  @TempDir Path folder;

  private JsonNode summary(Object... options) throws IOException {
    Path out = folder.resolve("o");
    Object[] command = new Object[options.length + 6];
    Object[] start = {"run", RING, "--steps", 100, "--out", out};
    System.arraycopy(start, 0, command, 0, start.length);
    System.arraycopy(options, 0, command, start.length, options.length);
    Cli run = Cli.run(command);
    assertEquals(0, run.exit(), run.err());
    return new ObjectMapper().readTree(out.resolve("summary.json").toFile());
  }

  @Test
  void runMeasuresFollowingWhenAsked() throws IOException {
    JsonNode summary = summary("--policy", "cooperative:identity=none", "--following", "targets");
    assertEquals("targets", summary.get("following").asText());
    assertTrue(summary.get("unbroken").asDouble() > 0, summary.toString());
    assertTrue(summary.get("handovers").asDouble() > 0, summary.toString());
    assertTrue(summary.get("losses").asDouble() >= summary.get("ended_losses").asDouble());
    assertTrue(summary.has("time_to_find_again"), summary.toString());
    assertTrue(summary.has("identity_switches"), summary.toString());
  }

  @Test
  void pageShowsWhichCameraHadEachTarget() throws IOException {
    JsonNode summary = summary("--policy", "tracker", "--following", "targets", "--record");
    Browser browser = Browser.shared();
    browser.open(folder.resolve("o/report.html").toUri().toString());
    browser.until("return document.getElementById('page').dataset.ready === '0'");
    assertEquals(summary.get("losses").asLong(), browser.run(LOSSES));
    assertEquals(summary.get("handovers").asLong(), browser.run(HANDOVERS));
    int targets = browser.findAll(".chart.targets .rows span").size();
    assertEquals((long) targets, browser.run("return hificamsim.run.setup.targets.length"));
    assertEquals(
        true,
        browser.run(
            "const strip = hificamsim.player.timeline.holders;"
                + "return hificamsim.run.holders.every((list, target) => list.every((holder, i) =>"
                + " strip.describe(target, i).includes(holder < 0 ? 'no camera covers it' :"
                + " hificamsim.run.setup.cameras[holder].name + ' has it')))"));
    browser.assertQuietConsole();
  }

  @Test
  void pageOfOtherRunsHasNoBarsOfTargets() throws IOException {
    summary("--record");
    Browser browser = Browser.shared();
    browser.open(folder.resolve("o/report.html").toUri().toString());
    browser.until("return document.getElementById('page').dataset.ready === '0'");
    assertTrue(browser.findAll(".chart.targets").isEmpty());
    assertFalse(Files.readString(folder.resolve("o/replay.json")).contains("following"));
  }

  @Test
  void onlyPoliciesWithTracksHaveIdentitySwitches() throws IOException {
    JsonNode summary = summary("--policy", "cooperative", "--following", "targets");
    assertFalse(summary.has("identity_switches"), summary.toString());
  }

  @Test
  void runWithoutFollowingHasNoFollowingMetrics() throws IOException {
    String summary = summary("--policy", "cooperative:identity=none").toString();
    for (String word : new String[] {"following", "unbroken", "handovers", "identity_switches"}) {
      assertFalse(summary.contains(word), word);
    }
  }

  @Test
  void camSimsNetworkCountsItsOwnHandovers() throws IOException {
    JsonNode plain = summary("--network", "camsim:strategies=A0");
    JsonNode followed = summary("--network", "camsim:strategies=A0", "--following", "targets");
    assertEquals(plain.get("handovers"), followed.get("handovers"));
    assertTrue(followed.has("unbroken"), followed.toString());
  }

  @Test
  void budgetForAllTargetsGivesTheSameTables() throws IOException {
    for (String policy : new String[] {"cooperative", "qb-sarsa", "tracker"}) {
      byte[] free = steps(policy, "none");
      assertArrayEquals(free, steps(policy, "100"), policy);
      assertFalse(Arrays.equals(free, steps(policy, "1")), policy);
    }
  }

  private byte[] steps(String policy, String budget) throws IOException {
    summary("--policy", policy, "--processing", budget, "--record");
    return Files.readAllBytes(folder.resolve("o/steps.csv"));
  }

  @Test
  void tightProcessingBudgetChangesUtilityOfNetwork() throws IOException {
    JsonNode free = summary("--network", "camsim:strategies=A0");
    JsonNode wide = summary("--network", "camsim:strategies=A0", "--processing", "100");
    JsonNode narrow = summary("--network", "camsim:strategies=A0", "--processing", "1");
    for (String metric : List.of("utility", "handovers", "messages", "bits", "tracked", "score")) {
      assertEquals(free.get(metric), wide.get(metric), metric);
    }
    assertNotEquals(free.get("utility"), narrow.get("utility"));
  }

  /** The pairs that listeners see are those that the network has counted, late ones too. */
  @ParameterizedTest
  @CsvSource({"camsim:strategies=A0, 1", "camsim:strategies=P2, 2", "camsim:strategies=HA1, 100"})
  void networkKnowsWhatItsCamerasProcess(String network, int budget) {
    Catalogue catalogue = Catalogue.load();
    Scenario scenario =
        ScenarioReader.read(RING, catalogue.movements()::knows, warning -> {})
            .with(Scenario.PROCESSING, new ProcessingBudget(budget));
    World world = new World(scenario, catalogue.movements(), 1);
    Detection detection = Detection.of(catalogue.detection("camsim-visibility"));
    Cooperation cooperation = catalogue.networks().create(network).begin(world, detection, 1);
    Behaviour behaviour = new Behaviour(catalogue.policies().create("zoom-out"), cooperation);
    StepListener check = (view, coverage) -> assertPairsAreCovered(view);
    new Simulation(world, detection, behaviour, 1, List.of(check)).run(200);
  }

  private static void assertPairsAreCovered(OracleView network) {
    SeenPairs pairs = new SeenPairs();
    network.findSeen(pairs);
    int[] covered = new int[network.targets()];
    for (int pair = 0; pair < pairs.count(); pair++) {
      covered[pairs.target(pair)]++;
    }
    for (int target = 0; target < covered.length; target++) {
      assertEquals(covered[target], network.coverage(target), "step " + network.step());
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"0", "-1", "1.5", "x", "many"})
  void rejectsInvalidBudgetsInOneLine(String budget) throws IOException {
    assertRejected("--processing", budget);
    Path scenario = folder.resolve("budget.xml");
    String text = Files.readString(RING);
    Files.writeString(
        scenario, text.replaceFirst("<simulation ", "<simulation processing=\"" + budget + "\" "));
    Cli run = Cli.run("validate", scenario);
    assertEquals(2, run.exit());
    assertTrue(run.err().contains("budget.xml:") && run.err().contains(budget), run.err());
  }

  @ParameterizedTest
  @ValueSource(strings = {"on", "", "Targets"})
  void rejectsUnknownFollowingInOneLine(String following) {
    assertRejected("--following", following);
  }

  private void assertRejected(String option, String value) {
    Cli run = Cli.run("run", RING, option, value, "--steps", 10, "--out", folder.resolve("o"));
    assertEquals(2, run.exit());
    assertEquals(1, run.err().lines().count(), run.err());
    assertTrue(run.err().contains(option), run.err());
  }
}
