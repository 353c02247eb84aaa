package org.hificamsim.agents.optimal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.Test;

/** Compares the policy with the best of all configurations. */
class OptimalExpectedZoomPolicyTest {
  /** Random chances: some are 0 or 1, some views are equal, and some are better for all targets. */
  private static final class RandomChances extends ToyNetwork {
    private final double[][][] chances;

    RandomChances(int targets, int[] views, SplittableRandom random) {
      super(targets, views);
      chances = new double[views.length][][];
      for (int camera = 0; camera < views.length; camera++) {
        chances[camera] = new double[views[camera]][targets];
        for (int view = 0; view < views[camera]; view++) {
          for (int target = 0; target < targets; target++) {
            double drawn = Math.max(0, Math.min(1, random.nextDouble(-0.5, 1.2)));
            chances[camera][view][target] = random.nextInt(4) == 0 ? Math.rint(drawn) : drawn;
          }
        }
      }
    }

    @Override
    public double chance(int camera, int view, int target) {
      return chances[camera][view][target];
    }

    /** The least expected coverage in these views. */
    double leastCoverage(int[] views) {
      double least = Double.POSITIVE_INFINITY;
      for (int target = 0; target < targets(); target++) {
        double sum = 0;
        for (int camera = 0; camera < cameras(); camera++) {
          sum += online(camera) ? chances[camera][views[camera]][target] : 0;
        }
        least = present(target) ? Math.min(least, sum) : least;
      }
      return least;
    }

    /** The greatest least coverage with the views of the cameras before {@code camera}. */
    double best(int[] views, int camera) {
      if (camera == cameras()) {
        return leastCoverage(views);
      }
      double best = 0;
      for (int view = 0; view < views(camera); view++) {
        views[camera] = view;
        best = Math.max(best, best(views, camera + 1));
      }
      return best;
    }
  }

  private static RandomChances network(int cameras, int targets, SplittableRandom random) {
    int[] views = new int[cameras];
    for (int camera = 0; camera < cameras; camera++) {
      views[camera] = 1 + random.nextInt(4);
    }
    return new RandomChances(targets, views, random);
  }

  @Property(tries = 300, edgeCases = EdgeCasesMode.NONE)
  void reachesTheBestLeastExpectedCoverage(
      @ForAll @IntRange(min = 1, max = 6) int cameras,
      @ForAll @IntRange(min = 1, max = 6) int targets,
      @ForAll long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    RandomChances network = network(cameras, targets, random);
    network.switchCamera(0, random.nextInt(4) > 0);
    network.showTarget(0, targets == 1 || random.nextInt(4) > 0);
    OptimalExpectedZoomPolicy policy =
        network.begin(
            new OptimalExpectedZoomPolicy(Options.parse("optimal-expected", "nodes=100000")), 1);
    network.decide(policy);
    double best = network.best(new int[cameras], 0);
    assertEquals(best, network.leastCoverage(network.currentViews()), 1e-8);
    assertEquals(0, policy.unprovenSteps());
    assertEquals(0, policy.gap());
  }

  @Property(tries = 100, edgeCases = EdgeCasesMode.NONE)
  void reportsGapAtNodeLimit(@ForAll long seed) {
    RandomChances network = network(6, 5, new SplittableRandom(seed));
    OptimalExpectedZoomPolicy policy =
        network.begin(
            new OptimalExpectedZoomPolicy(Options.parse("optimal-expected", "nodes=0")), 1);
    network.decide(policy);
    double reached = network.leastCoverage(network.currentViews());
    double best = network.best(new int[6], 0);
    assertTrue(reached + policy.gap() >= best - 1e-8, reached + " + " + policy.gap());
    assertTrue(policy.unprovenSteps() == 1 || reached >= best - 1e-8);
  }

  @Test
  void firstConfigurationIsSeldomFarFromTheBest() {
    double lost = 0;
    for (int seed = 0; seed < 200; seed++) {
      RandomChances network = network(6, 5, new SplittableRandom(seed));
      network.decide(
          network.begin(
              new OptimalExpectedZoomPolicy(Options.parse("optimal-expected", "nodes=0")), 1));
      double best = network.best(new int[6], 0);
      lost += 1 - network.leastCoverage(network.currentViews()) / best;
    }
    assertTrue(lost / 200 < 0.01, "lost " + lost / 200);
  }

  @Test
  void keepsViewsWithoutTargets() {
    RandomChances network = network(3, 1, new SplittableRandom(3));
    network.showTarget(0, false);
    int[] before = network.currentViews();
    network.decide(
        network.begin(
            new OptimalExpectedZoomPolicy(Options.parse("optimal-expected", "nodes=10")), 1));
    assertArrayEquals(before, network.currentViews());
  }

  @Test
  void reachesTheBestKMinWithAThreshold() {
    ToyNetwork network = new ToyNetwork(2, 2, 2, 1).see(0, 0, 0).see(0, 1, 1).see(1, 0, 1);
    network.see(1, 1, 0).see(2, 0, 0, 1);
    network.decide(
        network.begin(
            new OptimalExpectedZoomPolicy(Options.parse("optimal-expected", "nodes=10")), 1));
    network.observe();
    assertEquals(2, network.kMin());
  }
}
