package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.BiConsumer;
import java.util.stream.IntStream;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.detection.camsim.CamSimRangeDetection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.ScenarioEvent.AddCamera;
import org.hificamsim.core.scenario.spec.ScenarioEvent.AddTarget;
import org.hificamsim.core.scenario.spec.ScenarioEvent.FailCamera;
import org.hificamsim.core.scenario.spec.ScenarioEvent.RemoveTarget;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class SimulationTest {
  private static final Detection ALL_IN_REACH = Detection.of(new GeometricDetection());

  /** Decides by a given function, and logs its calls with the detections per camera. */
  private static class TestPolicy implements ZoomPolicy {
    private final BiConsumer<NetworkView, int[]> decide;
    private final List<String> log = new ArrayList<>();

    TestPolicy(BiConsumer<NetworkView, int[]> decide) {
      this.decide = decide;
    }

    @Override
    public String name() {
      return "test";
    }

    @Override
    public void begin(NetworkView network, SplittableRandom random) {
      log.add("begin");
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      log.add("decide " + network.step() + " " + detected(network));
      decide.accept(network, views);
    }

    @Override
    public void learn(NetworkView network) {
      log.add("learn " + network.step() + " " + detected(network));
    }
  }

  private static String detected(NetworkView network) {
    StringBuilder text = new StringBuilder();
    for (int camera = 0; camera < network.cameras(); camera++) {
      text.append(network.detected(camera));
    }
    return text.toString();
  }

  private static TestPolicy widest() {
    return new TestPolicy((network, views) -> new WidestPolicy().decide(network, views));
  }

  /** A scenario whose target leaves the reach of the camera with its third step. */
  private static TestScenario leavingTarget(StepOrder order) {
    return new TestScenario().order(order).camera(0, 0).target(2.5, 0, 90, 1);
  }

  @Test
  void coverageObservesThenMoves() {
    List<String> seen = new ArrayList<>();
    simulation(leavingTarget(StepOrder.COVERAGE), widest(), recorder(seen)).run(5);
    assertEquals(List.of("2.5:1", "3.5:1", "4.5:1", "5.5:0", "6.5:0"), seen);
  }

  @Test
  void camsimMovesThenObserves() {
    List<String> seen = new ArrayList<>();
    simulation(leavingTarget(StepOrder.CAMSIM), widest(), recorder(seen)).run(4);
    assertEquals(List.of("3.5:1", "4.5:1", "5.5:0", "6.5:0"), seen);
  }

  private static StepListener recorder(List<String> seen) {
    return (network, coverage) -> seen.add(network.targetX(0) + ":" + coverage.kMin());
  }

  @Test
  void learnsFromObservationAfterDecision() {
    TestPolicy policy = widest();
    simulation(leavingTarget(StepOrder.CAMSIM), policy).run(4);
    assertEquals(
        List.of(
            "begin",
            "decide 0 0",
            "learn 0 1",
            "decide 1 1",
            "learn 1 1",
            "decide 2 1",
            "learn 2 0",
            "decide 3 0",
            "learn 3 0"),
        policy.log);
  }

  @Test
  void learnsUnderJustChosenLevels() {
    TestScenario scenario = new TestScenario().zooms(1, 5).camera(0, 0).target(3, 0);
    TestPolicy policy = new TestPolicy((network, views) -> views[0] = (int) network.step() % 2);
    simulation(scenario, policy).run(4);
    assertEquals("learn 0 0", policy.log.get(2));
    assertEquals("learn 1 1", policy.log.get(4));
    assertEquals("learn 2 0", policy.log.get(6));
    assertEquals("learn 3 1", policy.log.get(8));
  }

  @Test
  void camerasDecideFromSameSnapshot() {
    List<String> levelsSeen = new ArrayList<>();
    TestPolicy policy =
        new TestPolicy(
            (network, views) -> {
              for (int camera = 0; camera < views.length; camera++) {
                views[camera] = (network.view(camera) + 1) % 3;
                levelsSeen.add(network.view(0) + "" + network.view(1) + detected(network));
              }
            });
    simulation(new TestScenario().zooms(1, 2, 4).camera(0, 0).camera(1, 0).target(3, 0), policy)
        .run(3);
    assertEquals(List.of("2200", "2200", "0000", "0000", "1101", "1101"), levelsSeen);
  }

  @Test
  void policyReceivesCurrentLevels() {
    List<String> receivedViews = new ArrayList<>();
    TestPolicy policy =
        new TestPolicy(
            (network, views) -> {
              receivedViews.add(Arrays.toString(views));
              views[0] = 1;
            });
    simulation(new TestScenario().zooms(1, 2, 3).camera(0, 0).camera(0, 0).target(0, 0), policy)
        .run(2);
    assertEquals(List.of("[2, 2]", "[1, 2]"), receivedViews);
  }

  @Test
  void ignoresViewOfOfflineCamera() {
    TestScenario scenario =
        new TestScenario()
            .zooms(1, 5)
            .camera(0, 0)
            .camera(0, 0)
            .target(3, 0)
            .events(new FailCamera(2, "c0", -1));
    TestPolicy policy =
        new TestPolicy(
            (network, views) -> {
              views[0] = network.online(0) ? 1 : 99;
              views[1] = 1;
            });
    Simulation simulation = simulation(scenario, policy);
    simulation.run(4);
    assertEquals("learn 1 11", policy.log.get(4));
    assertEquals("learn 2 01", policy.log.get(6));
    assertEquals("learn 3 01", policy.log.get(8));
    assertEquals(1, simulation.network().view(0));
    assertEquals(1, simulation.coverage().kMin());
  }

  @Test
  void laterCameraTakesPartFromItsStep() {
    TestScenario scenario =
        new TestScenario()
            .camera(0, 0)
            .target(3, 0)
            .events(new AddCamera(2, TestScenario.camera("late", 3, 0, 0, 360, 5)));
    TestPolicy policy = widest();
    simulation(scenario, policy).run(3);
    assertEquals("learn 1 10", policy.log.get(4));
    assertEquals("learn 2 11", policy.log.get(6));
  }

  @Test
  void seesOnlyPresentTargets() {
    TestScenario scenario =
        new TestScenario()
            .camera(0, 0)
            .target(3, 0)
            .events(
                new AddTarget(1, TestScenario.target(9, 1, 0, 0, 0)),
                new RemoveTarget(2, 0),
                new RemoveTarget(3, 9));
    List<String> seen = new ArrayList<>();
    Simulation simulation =
        simulation(
            scenario,
            widest(),
            (network, coverage) ->
                seen.add(coverage.targets() + ":" + coverage.kMin() + ":" + network.detected(0)));
    simulation.run(4);
    assertEquals(List.of("1:1:1", "2:1:2", "1:1:1", "0:0:0"), seen);
    assertEquals(0, simulation.network().confidence(0, 0), "no confidence in what is not there");
    assertEquals(0, simulation.network().coverage(0));
  }

  @ParameterizedTest
  @ValueSource(ints = {-1, 2, 99})
  void errorOfInvalidViewNamesThePolicy(int view) {
    TestPolicy policy = new TestPolicy((network, views) -> views[1] = view);
    Simulation simulation =
        simulation(new TestScenario().zooms(1, 2).camera(0, 0).camera(0, 0).target(0, 0), policy);
    IllegalStateException error =
        assertThrows(IllegalStateException.class, () -> simulation.run(1));
    assertEquals(
        "policy test chose view " + view + " for camera c1, expected 0 to 1", error.getMessage());
  }

  @Test
  void callsListenersInOrder() {
    List<String> calls = new ArrayList<>();
    simulation(leavingTarget(StepOrder.CAMSIM), widest(), logger("a", calls), logger("b", calls))
        .run(2);
    assertEquals(
        List.of("a started", "b started", "a 0", "b 0", "a 1", "b 1", "a ended", "b ended"), calls);
  }

  private static StepListener logger(String name, List<String> calls) {
    return new StepListener() {
      @Override
      public void started(OracleView network) {
        calls.add(name + " started");
      }

      @Override
      public void stepped(OracleView network, StepCoverage coverage) {
        calls.add(name + " " + network.step());
      }

      @Override
      public void ended(OracleView network) {
        calls.add(name + " ended");
      }
    };
  }

  @ParameterizedTest
  @EnumSource(StepOrder.class)
  void coverageEqualsBruteForce(StepOrder order) {
    SplittableRandom random = new SplittableRandom(5);
    TestScenario scenario = new TestScenario().order(order).zooms(2, 5, 9);
    for (int i = 0; i < 8; i++) {
      double angle = i % 2 == 0 ? 360 : 120;
      scenario.camera(
          TestScenario.camera(
              "c" + i, random.nextInt(-9, 9), random.nextInt(-9, 9), 50 * i, angle, 0));
      scenario.target(random.nextInt(-9, 9), random.nextInt(-9, 9), 77 * i, 0.7);
    }
    SplittableRandom levelsRandom = new SplittableRandom(6);
    TestPolicy policy =
        new TestPolicy((network, views) -> Arrays.setAll(views, camera -> levelsRandom.nextInt(3)));
    RunCoverage total = new RunCoverage();
    long[] sums = new long[6];
    StepListener bruteForce =
        (network, coverage) -> {
          int[] k = new int[network.targets()];
          for (int camera = 0; camera < network.cameras(); camera++) {
            int detected = 0;
            for (int target = 0; target < k.length; target++) {
              boolean sees = network.detects(camera, network.view(camera), target);
              k[target] += sees ? 1 : 0;
              detected += sees ? 1 : 0;
            }
            assertEquals(detected, network.detected(camera));
          }
          for (int target = 0; target < k.length; target++) {
            assertEquals(k[target], network.coverage(target));
          }
          int least = Arrays.stream(k).min().orElseThrow();
          assertEquals(least, coverage.kMin());
          sums[0] += least;
          sums[1] += Arrays.stream(k).filter(count -> count == 0).count();
          sums[2] += Arrays.stream(k).filter(count -> count == 1).count();
          sums[3] += Arrays.stream(k).filter(count -> count >= 2).count();
          sums[4] += Arrays.stream(k).sum();
          sums[5]++;
        };
    simulation(scenario, policy, bruteForce, total).run(300);
    double targets = 8 * 300;
    assertEquals(300, sums[5]);
    assertEquals(300, total.steps());
    assertEquals(sums[0], total.performance());
    assertEquals(sums[0] / 300.0, total.meanKMin());
    assertEquals(sums[1] / targets, total.proportion0());
    assertEquals(sums[2] / targets, total.proportion1());
    assertEquals(sums[3] / targets, total.proportionK());
    assertEquals(sums[4] / targets, total.meanK(), 1e-12);
    assertEquals(sums[4], total.detections());
    assertTrue(sums[1] > 0 && sums[2] > 0 && sums[3] > 0, "all of them happened");
  }

  @Test
  void scoresByObjectiveOfScenario() {
    TestScenario base = new TestScenario().zooms(2, 4, 7).camera(0, 0).camera(5, 0);
    IntStream.range(0, 70).forEach(i -> base.target(-9 + i * 0.25, 1, 90, 0.1));
    for (String text : List.of("kmin", "covered:k=2", "lexicographic", "sum:cap=1")) {
      Scenario scenario = base.scenario().with(Scenario.OBJECTIVE, Objective.parse(text));
      RunCoverage total = new RunCoverage();
      double[] sum = new double[1];
      StepListener bruteForce =
          (network, coverage) -> {
            assertEquals(scenario.objective(), network.objective());
            int[] k =
                IntStream.range(0, network.targets())
                    .filter(target -> !text.equals("lexicographic") || coverable(network, target))
                    .map(network::coverage)
                    .toArray();
            assertEquals(scenario.objective().score(k, 0, k.length), coverage.score());
            sum[0] += coverage.score();
          };
      new Simulation(
              new World(scenario, Movements.registry(), 1),
              ALL_IN_REACH,
              widest(),
              1,
              List.of(bruteForce, total))
          .run(20);
      assertEquals(sum[0], total.score(), text);
      assertEquals(!text.equals("kmin"), sum[0] > 0, text + " " + sum[0]);
    }
  }

  private static boolean coverable(OracleView network, int target) {
    return IntStream.range(0, network.cameras())
        .anyMatch(
            camera ->
                IntStream.range(0, network.views(camera))
                    .anyMatch(view -> network.detects(camera, view, target)));
  }

  @Test
  void phasesMakeSameStepsAsWholeSteps() {
    List<String> inWholeSteps = new ArrayList<>();
    List<String> inPhases = new ArrayList<>();
    simulation(leavingTarget(StepOrder.CAMSIM), widest(), recorder(inWholeSteps)).run(3);
    StepPhases phases =
        simulation(leavingTarget(StepOrder.CAMSIM), widest(), recorder(inPhases)).phases();
    for (int step = 0; step < 3; step++) {
      for (StepPhase phase : StepPhase.values()) {
        phases.runUntil(phase);
        assertEquals(phase, phases.next());
      }
      assertEquals(step, inPhases.size() - 1, "steps reported");
      phases.finishStep();
      assertEquals(StepPhase.FIRE_EVENTS, phases.next());
    }
    assertEquals(inWholeSteps, inPhases);
  }

  @Test
  void rejectsStepWithinStep() {
    Simulation simulation = simulation(leavingTarget(StepOrder.CAMSIM), widest());
    simulation.phases().runUntil(StepPhase.OBSERVE);
    assertThrows(IllegalStateException.class, simulation::step);
    simulation.phases().finishStep();
    simulation.step();
    assertEquals(1, simulation.network().step());
  }

  @Test
  void coverageIsZeroWithoutStepsOrTargets() {
    RunCoverage withoutSteps = new RunCoverage();
    simulation(new TestScenario().camera(0, 0), widest(), withoutSteps).run(0);
    assertEquals(0, withoutSteps.meanKMin());
    assertEquals(0, withoutSteps.meanK());
    RunCoverage withoutTargets = new RunCoverage();
    simulation(new TestScenario().camera(0, 0), widest(), withoutTargets).run(3);
    assertEquals(3, withoutTargets.steps());
    assertEquals(0, withoutTargets.performance());
    assertEquals(
        0,
        withoutTargets.proportion0() + withoutTargets.proportion1() + withoutTargets.proportionK());
  }

  @Test
  void confidenceIsClampedAndZeroOutsideView() {
    TestScenario scenario =
        new TestScenario()
            .zooms(2, 5)
            .camera(TestScenario.camera("a", 0, 0, 90, 90, 0))
            .target(1, 0)
            .target(4, 0)
            .target(-1, 0)
            .target(6, 0);
    Simulation simulation =
        new Simulation(
            scenario.world(), Detection.of(new CamSimRangeDetection()), widest(), 0, List.of());
    simulation.run(1);
    NetworkView network = simulation.network();
    assertEquals(1, network.confidence(0, 0), "2.7, clamped");
    assertEquals(0.95 * (15.0 / 20) - 0.15, network.confidence(0, 1));
    assertEquals(0, network.confidence(0, 2), "behind");
    assertEquals(0, network.confidence(0, 3), "too far");
  }

  @Test
  void passesAngleToBearingModels() {
    TestScenario scenario =
        new TestScenario().camera(TestScenario.camera("a", 0, 0, 0, 90, 5)).target(1, 2);
    Simulation simulation =
        new Simulation(
            scenario.world(),
            Detection.of(new CamSimVisibilityDetection()),
            widest(),
            0,
            List.of());
    simulation.run(1);
    double distance = Math.sqrt(5);
    double half = Math.PI / 4;
    assertEquals(
        1 / (distance + (5 - distance) / 5) * (half - Math.atan2(1, 2)) / half,
        simulation.network().confidence(0, 0),
        1e-12);
  }

  private static Simulation simulation(
      TestScenario scenario, ZoomPolicy policy, StepListener... listeners) {
    return new Simulation(scenario.world(), ALL_IN_REACH, policy, 0, List.of(listeners));
  }

  @Test
  void continuesAtGivenStep() {
    TestPolicy policy = widest();
    simulation(leavingTarget(StepOrder.CAMSIM), policy).continuingAt(7).run(1);
    assertEquals(List.of("begin", "decide 7 0", "learn 7 1"), policy.log);
  }

  @Test
  void cooperatesBeforeDecidingAndAfterObserving() {
    TestPolicy policy = widest();
    Cooperation cooperation =
        new Cooperation() {
          @Override
          public void prepare() {
            policy.log.add("prepare");
          }

          @Override
          public void cooperate() {
            policy.log.add("cooperate");
          }
        };
    World world = leavingTarget(StepOrder.CAMSIM).world();
    new Simulation(world, ALL_IN_REACH, new Behaviour(policy, cooperation), 0, List.of()).run(1);
    assertEquals(List.of("begin", "prepare", "decide 0 0", "cooperate", "learn 0 1"), policy.log);
  }
}
