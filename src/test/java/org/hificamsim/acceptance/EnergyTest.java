package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.energy.EnergyFigure;
import org.hificamsim.core.energy.EnergyModel;
import org.hificamsim.core.engine.Behaviour;
import org.hificamsim.core.engine.Cooperation;
import org.hificamsim.core.engine.EnergyMeter;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests energy as commands report it, by recounting it from what cameras did. */
class EnergyTest {
  private static final Path RING = Cli.ROOT.resolve("scenarios/ring-random.xml");
  private static final EnergyModel MODEL =
      EnergyModel.parse(
          "idle=0.3W,sense=12mJ,detection=5mJ,send=1mJ,receive=2mJ,pan=0.1J,zoom=0.7J");
  private static final int STEPS = 200;

  @TempDir Path folder;

  /** Counts what takes energy, from the views and detections of each step. */
  private static final class Recount {
    private int[] lastViews;
    private double joules;

    void stepped(OracleView network, StepCoverage coverage) {
      int cameras = network.cameras();
      joules += cameras * (0.3 + 0.012) + 0.005 * coverage.detections();
      for (int camera = 0; camera < cameras && lastViews != null; camera++) {
        int from = network.zoomOf(camera, lastViews[camera]);
        joules += 0.7 * Math.abs(network.zoomOf(camera, network.view(camera)) - from);
      }
      lastViews = new int[cameras];
      for (int camera = 0; camera < cameras; camera++) {
        lastViews[camera] = network.view(camera);
      }
    }
  }

  @ParameterizedTest
  @CsvSource({"cooperative, others", "qb-sarsa, one", "softmax, one", "zoom-out, one"})
  void joulesEqualRecountOfMessagesAndViews(String policyName, String receivers) {
    Catalogue catalogue = Catalogue.load();
    ZoomPolicy policy = catalogue.policies().create(policyName);
    Recount recount = new Recount();
    Simulation simulation = simulation(catalogue, policy, Cooperation.NONE, recount);
    int others = simulation.network().cameras() - 1;
    double received = (double) policy.bits() * (receivers.equals("others") ? others : 1);
    double expected = recount.joules + 0.001 * policy.bits() + 0.002 * received;
    assertEquals(expected, simulation.energy().joules(), 1e-9 * expected);
    assertSumOfParts(simulation);
  }

  @Test
  void networkSendsAndReceivesTheBitsThatItCounts() {
    Catalogue catalogue = Catalogue.load();
    Scenario scenario = scenario(catalogue);
    World world = new World(scenario, catalogue.movements(), 1);
    Detection detection = Detection.of(catalogue.detection("camsim-visibility"));
    Cooperation network =
        catalogue.networks().create("camsim:strategies=A0").begin(world, detection, 1);
    ZoomPolicy policy = catalogue.policies().create("zoom-out");
    Simulation simulation =
        new Simulation(world, detection, new Behaviour(policy, network), 1, List.of());
    simulation.run(STEPS);
    EnergyMeter meter = simulation.energyMeter().orElseThrow();
    double sent = sum(meter, EnergyFigure.SEND, world.cameras().count());
    assertEquals(0.001 * network.sums().bits(), sent, 1e-9 * sent);
    assertTrue(sum(meter, EnergyFigure.RECEIVE, world.cameras().count()) > sent);
    assertSumOfParts(simulation);
  }

  private static Scenario scenario(Catalogue catalogue) {
    return ScenarioReader.read(RING, catalogue.movements()::knows, warning -> {})
        .with(Scenario.ENERGY, MODEL);
  }

  private static Simulation simulation(
      Catalogue catalogue, ZoomPolicy policy, Cooperation cooperation, Recount recount) {
    World world = new World(scenario(catalogue), catalogue.movements(), 1);
    Detection detection = Detection.of(catalogue.detection("hifi:orb-lin"));
    Simulation simulation =
        new Simulation(
            world,
            detection,
            new Behaviour(policy, cooperation),
            1,
            List.of((network, coverage) -> recount.stepped(network, coverage)));
    simulation.run(STEPS);
    return simulation;
  }

  private static double sum(EnergyMeter meter, EnergyFigure figure, int cameras) {
    double sum = 0;
    for (int camera = 0; camera < cameras; camera++) {
      sum += meter.joules(camera, figure);
    }
    return sum;
  }

  private static void assertSumOfParts(Simulation simulation) {
    EnergyMeter meter = simulation.energyMeter().orElseThrow();
    double sum = 0;
    for (EnergyFigure figure : EnergyFigure.values()) {
      sum += sum(meter, figure, simulation.network().cameras());
    }
    assertEquals(sum, simulation.energy().joules(), 1e-9 * sum);
  }

  @Test
  void runReportsEnergyAndLifetimes() throws IOException {
    Path profile = folder.resolve("mote.energy");
    Files.writeString(profile, "cc2420\nidle = 1 W # awake\nbattery = 49.5 J\n");
    Cli run =
        Cli.run("run", RING, "--energy", profile, "--steps", 100, "--out", folder.resolve("o"));
    assertEquals(0, run.exit(), run.err());
    assertTrue(run.out().contains("first battery empty"), run.out());
    String summary = Files.readString(folder.resolve("o/summary.json"));
    assertTrue(summary.replace(" ", "").contains("\"lifetime_first\":50"), summary);
    assertTrue(summary.contains("send=2.088E-7J"), summary);
  }

  @Test
  void runWithoutEnergyProfileHasNoEnergyMetrics() throws IOException {
    Cli run = Cli.run("run", RING, "--steps", 10, "--out", folder.resolve("o"));
    assertEquals(0, run.exit(), run.err());
    assertFalse(Files.readString(folder.resolve("o/summary.json")).contains("energy_model"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"sense=-1mJ", "sense=NaNJ", "battery=0J", "nobody", "sense=1parsec"})
  void rejectsInvalidProfilesInOneLine(String energy) {
    Cli run = Cli.run("run", RING, "--energy", energy, "--steps", 10, "--out", folder.resolve("o"));
    assertEquals(2, run.exit());
    assertEquals(1, run.err().lines().count(), run.err());
    assertTrue(run.err().contains("--energy") || run.err().contains("energy:"), run.err());
  }

  @Test
  void rejectsDutyCycleOfZeroWithItsPlace() throws IOException {
    Path scenario = folder.resolve("duty.xml");
    Files.writeString(
        scenario, Files.readString(RING).replaceFirst("<camera ", "<camera duty=\"0/4\" "));
    Cli run = Cli.run("validate", scenario);
    assertEquals(2, run.exit());
    assertTrue(run.err().contains("duty"), run.err());
    assertTrue(run.err().contains("AWAKE/PERIOD"), run.err());
  }
}
