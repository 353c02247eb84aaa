package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.camsim.CamSimRangeDetection;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.spec.ScenarioEvent.AddTarget;
import org.hificamsim.core.scenario.spec.ScenarioEvent.FailCamera;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.junit.jupiter.api.Test;

/** Tests that equal arguments give runs that are equal in all observable values. */
class DeterminismTest {
  private static final int STEPS = 2000;

  /** Zooms at random. */
  private static final class RandomPolicy implements ZoomPolicy {
    private SplittableRandom random;

    @Override
    public String name() {
      return "random";
    }

    @Override
    public void begin(NetworkView network, SplittableRandom newRandom) {
      random = newRandom;
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      for (int camera = 0; camera < views.length; camera++) {
        views[camera] = random.nextInt(network.views(camera));
      }
    }
  }

  @Test
  void sameSeedsGiveSameRun() {
    List<Integer> first = run(1, 2);
    List<Integer> second = run(1, 2);
    assertEquals(STEPS, first.size(), "steps compared");
    assertEquals(first, second);
  }

  @Test
  void policySeedChangesRun() {
    assertNotEquals(run(1, 2), run(1, 3));
  }

  @Test
  void worldSeedChangesRun() {
    assertNotEquals(run(1, 2), run(4, 2));
  }

  /** Returns a hash of all observable values per step. */
  private static List<Integer> run(long worldSeed, long policySeed) {
    TestScenario scenario = new TestScenario().zooms(2, 4, 6, 8);
    for (int i = 0; i < 5; i++) {
      scenario.camera(4 * i - 8, 2 * i - 4).target(i, -i, 60 * i, 0.8);
    }
    scenario
        .target(
            TestScenario.target(9, 0, 0, 0, 0).withMovement("Brownian").with(TargetSpec.STD, 0.4))
        .target(TestScenario.walker(10, "Scripted", 0.3, 0, 0, 5, 5, 5, 0))
        .events(
            new AddTarget(700, TestScenario.target(11, 3, 3, 20, 1)),
            new FailCamera(900, "c2", -1));
    List<Integer> hashes = new ArrayList<>();
    new Simulation(
            scenario.world(worldSeed),
            Detection.of(new CamSimRangeDetection()),
            new RandomPolicy(),
            policySeed,
            List.of((StepListener) (network, coverage) -> hashes.add(hash(network, coverage))))
        .run(STEPS);
    return hashes;
  }

  private static int hash(OracleView network, StepCoverage coverage) {
    List<Object> observed = new ArrayList<>();
    observed.add(coverage.kMin());
    observed.add(coverage.meanK());
    observed.add(coverage.covered0());
    observed.add(coverage.covered1());
    for (int camera = 0; camera < network.cameras(); camera++) {
      observed.add(network.online(camera));
      observed.add(network.view(camera));
      observed.add(network.detected(camera));
    }
    for (int target = 0; target < network.targets(); target++) {
      observed.add(network.present(target));
      observed.add(network.targetX(target));
      observed.add(network.targetY(target));
      observed.add(network.coverage(target));
      observed.add(network.confidence(0, target));
    }
    return observed.hashCode();
  }
}
