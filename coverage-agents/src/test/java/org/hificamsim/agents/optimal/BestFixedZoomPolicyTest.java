package org.hificamsim.agents.optimal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.agents.CoveragePolicies;
import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.solver.configuration.CoverageProblem;
import org.hificamsim.solver.configuration.RunSolver;
import org.hificamsim.solver.configuration.Solver;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;

class BestFixedZoomPolicyTest {
  private static final int VIEWS = 3;

  private Objective objective = Objective.kMin();

  @RepeatedTest(200)
  void equalsTheBestOfAllConstantConfigurations(RepetitionInfo repetition) {
    SplittableRandom random = new SplittableRandom(repetition.getCurrentRepetition());
    int cameras = 1 + random.nextInt(5);
    int targets = 1 + random.nextInt(4);
    String[] texts = {"kmin", "covered:k=1", "covered:k=2", "sum:cap=2", "lexicographic"};
    objective = Objective.parse(texts[repetition.getCurrentRepetition() % texts.length]);
    RunDetections run = randomRun(random, cameras, targets, 12, 0.3);
    Found found = search(run, Solver.UNLIMITED);
    assertTrue(found.proven());
    assertEquals(0, found.gap());
    assertEquals(bestByTryingAll(run), performance(run, found.views()));
  }

  @Test
  void claimsNoProofWithoutNodes() {
    RunDetections run = randomRun(new SplittableRandom(1), 6, 4, 30, 0.5);
    Found found = search(run, 0);
    assertFalse(found.proven());
    double reached = performance(run, found.views());
    double best = bestByTryingAll(run);
    assertTrue(reached <= best && best <= reached + found.gap());
  }

  /** Without nodes, and with 200 of them: the result depends on where the limit ends the search. */
  @Test
  void findsAndProvesTheSameAsEarlierVersions() {
    objective = Objective.parse("covered:k=2");
    SplittableRandom random = new SplittableRandom(2);
    double climbed = 0;
    double searched = 0;
    int proven = 0;
    for (int trial = 0; trial < 100; trial++) {
      RunDetections run = randomRun(random, 6, 4, 12, 0.3);
      climbed += performance(run, search(run, 0).views());
      Found found = search(run, 200);
      searched += performance(run, found.views());
      proven += found.proven() ? 1 : 0;
    }
    assertEquals(
        "80350 80475 79",
        Math.round(climbed * 100) + " " + Math.round(searched * 100) + " " + proven);
  }

  @Test
  void letsCamerasJumpAndProvesNothingWithoutNodes() {
    BestFixedZoomPolicy policy =
        (BestFixedZoomPolicy)
            CoveragePolicies.register(new Registry<ZoomPolicy>("policy"))
                .create("best-fixed:nodes=0");
    assertTrue(policy.jumps());
    ToyNetwork network = new ToyNetwork(3, VIEWS, VIEWS);
    network.see(0, 0, 0);
    network.see(0, 1, 1);
    network.see(1, 0, 1);
    network.see(1, 1, 2);
    policy.rehearse(network);
    policy.begin(network, new SplittableRandom(0));
    policy.decide(network, new int[2]);
    assertFalse(policy.proven());
  }

  @Test
  void findsGainsOfTwoCamerasWithoutNodes() {
    ToyNetwork network = new ToyNetwork(5, VIEWS, VIEWS);
    network.see(0, 0, 0);
    network.see(0, 1, 1);
    network.see(0, 2, 2);
    network.see(1, 0, 0);
    network.see(1, 1, 3);
    network.see(1, 2, 4);
    RunDetections run = new RunDetections();
    run.add(network.scoredBy(Objective.parse("covered:k=2")));
    assertArrayEquals(new int[] {0, 0}, search(run, 0).views());
  }

  @Test
  void takesTheNarrowestOfEquallyGoodViews() {
    ToyNetwork network = new ToyNetwork(1, VIEWS, VIEWS);
    network.see(0, 1, 0);
    network.see(0, 2, 0);
    RunDetections run = new RunDetections();
    run.add(network);
    assertArrayEquals(new int[] {1, 0}, search(run, 10).views());
  }

  @Test
  void keepsItsViews() {
    BestFixedZoomPolicy policy =
        (BestFixedZoomPolicy)
            CoveragePolicies.register(new Registry<ZoomPolicy>("policy")).create("best-fixed");
    ToyNetwork network = new ToyNetwork(2, VIEWS);
    network.see(0, 1, 0, 1);
    network.see(0, 2, 1);
    policy.rehearse(network);
    policy.begin(network, new SplittableRandom(0));
    int[] views = {0};
    for (int step = 0; step < 3; step++) {
      policy.decide(network, views);
      assertEquals(1, views[0]);
    }
    assertTrue(policy.proven());
  }

  private RunDetections randomRun(
      SplittableRandom random, int cameras, int targets, int steps, double density) {
    RunDetections run = new RunDetections();
    int[] sizes = new int[cameras];
    Arrays.fill(sizes, VIEWS);
    for (int step = 0; step < steps; step++) {
      ToyNetwork network = new ToyNetwork(targets, sizes);
      for (int camera = 0; camera < cameras; camera++) {
        for (int view = 0; view < VIEWS; view++) {
          network.see(
              camera,
              view,
              random
                  .ints(0, targets)
                  .limit(targets)
                  .filter(target -> random.nextDouble() < density)
                  .distinct()
                  .toArray());
        }
      }
      run.add(network.scoredBy(objective));
    }
    return run;
  }

  private record Found(int[] views, boolean proven, double gap) {}

  private static Found search(RunDetections run, long nodes) {
    CoverageProblem problem = run.problem();
    RunSolver solver = new RunSolver(run.objective(), problem, run.ends(), nodes);
    solver.solve();
    int[] views = new int[problem.cameras()];
    Arrays.setAll(views, camera -> solver.chosen(camera) - problem.firstSet(camera));
    return new Found(views, solver.proven(), solver.gap());
  }

  private static double bestByTryingAll(RunDetections run) {
    int[] views = new int[run.problem().cameras()];
    double best = 0;
    do {
      best = Math.max(best, performance(run, views));
    } while (next(views));
    return best;
  }

  private static boolean next(int[] views) {
    for (int camera = 0; camera < views.length; camera++) {
      views[camera] = (views[camera] + 1) % VIEWS;
      if (views[camera] != 0) {
        return true;
      }
    }
    return false;
  }

  private static double performance(RunDetections run, int[] views) {
    CoverageProblem problem = run.problem();
    int[] coverage = new int[problem.targets()];
    for (int camera = 0; camera < views.length; camera++) {
      for (int moment = 0; moment < coverage.length; moment++) {
        coverage[moment] +=
            problem.contains(problem.firstSet(camera) + views[camera], moment) ? 1 : 0;
      }
    }
    double sum = 0;
    int from = 0;
    for (int end : run.ends()) {
      sum += run.objective().score(coverage, from, end);
      from = end;
    }
    return sum;
  }
}
