package org.hificamsim.core.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares expected coverage with a sum over all outcomes. */
class ExpectedCoverageTest {
  private static final double ERROR = 1e-12;

  /** Chances by camera and target; a target with negative chances is absent. */
  private record Chances(double[][] values) implements DetectionChances {
    @Override
    public int cameras() {
      return values.length;
    }

    @Override
    public int targets() {
      return values[0].length;
    }

    @Override
    public boolean present(int target) {
      return values[0][target] >= 0;
    }

    @Override
    public int chances(int camera, int[] targets, double[] chances) {
      int count = 0;
      for (int target = 0; target < targets(); target++) {
        if (values[camera][target] > 0) {
          targets[count] = target;
          chances[count++] = values[camera][target];
        }
      }
      return count;
    }
  }

  @Property(tries = 100, edgeCases = EdgeCasesMode.NONE)
  void equalsMeanOverAllOutcomes(
      @ForAll @IntRange(min = 1, max = 4) int cameras,
      @ForAll @IntRange(min = 1, max = 3) int targets,
      @ForAll long seed) {
    Chances chances = random(cameras, targets, new SplittableRandom(seed));
    ExpectedCoverage expected = new ExpectedCoverage();
    expected.measure(random(5, 7, new SplittableRandom(1))); // earlier measurements are forgotten
    expected.measure(chances);
    double[] sums = new double[5];
    double[] means = new double[targets];
    double[] once = new double[targets];
    double[] more = new double[targets];
    for (int outcome = 0; outcome < 1 << (cameras * targets); outcome++) {
      double weight = weight(chances, outcome);
      int least = Integer.MAX_VALUE;
      int present = 0;
      for (int target = 0; target < targets; target++) {
        if (chances.present(target)) {
          present++;
          int k = covering(outcome, cameras, target);
          least = Math.min(least, k);
          sums[Math.min(k, 2)] += weight;
          means[target] += weight * k;
          once[target] += k >= 1 ? weight : 0;
          more[target] += k >= 2 ? weight : 0;
        }
      }
      sums[3] += present == 0 ? 0 : weight * least;
      sums[4] = present;
    }
    assertEquals(sums[0], expected.covered0(), ERROR);
    assertEquals(sums[1], expected.covered1(), ERROR);
    assertEquals(sums[2], expected.coveredK(), ERROR);
    assertEquals(sums[3], expected.kMin(), ERROR);
    double leastMean = Double.POSITIVE_INFINITY;
    double leastOnce = Double.POSITIVE_INFINITY;
    double sum = 0;
    for (int target = 0; target < targets; target++) {
      if (chances.present(target)) {
        assertEquals(once[target], expected.chanceOfOne(target), ERROR);
        assertEquals(more[target], expected.chanceOfMore(target), ERROR);
        leastMean = Math.min(leastMean, means[target]);
        leastOnce = Math.min(leastOnce, once[target]);
        sum += means[target];
      }
    }
    assertEquals(sums[4] == 0 ? 0 : leastMean, expected.leastK(), ERROR);
    assertEquals(sums[4] == 0 ? 0 : leastOnce, expected.leastChance(), ERROR);
    assertEquals(sums[4] == 0 ? 0 : sum / sums[4], expected.meanK(), ERROR);
  }

  @Test
  void equalsCoverageOfCertainDetections() {
    ExpectedCoverage expected = new ExpectedCoverage();
    expected.measure(new Chances(new double[][] {{1, 1, 0}, {1, 0, 0}, {1, 1, 1}}));
    assertEquals(1, expected.kMin());
    assertEquals(0, expected.covered0());
    assertEquals(1, expected.covered1());
    assertEquals(2, expected.coveredK());
    assertEquals(2, expected.meanK());
  }

  @ParameterizedTest
  @ValueSource(ints = {6, 7, 8, 20, 40})
  void acceptsAnyNumberOfCameras(int cameras) {
    ExpectedCoverage expected = new ExpectedCoverage();
    expected.measure(random(5, 7, new SplittableRandom(1))); // an earlier, smaller network
    double[][] halves = new double[cameras][2];
    for (double[] half : halves) {
      half[0] = 0.5;
      half[1] = 1;
    }
    expected.measure(new Chances(halves));
    assertEquals(cameras / 2.0, expected.kMin(), ERROR, "the mean of a binomial");
    assertEquals(Math.pow(2, -cameras), expected.covered0(), ERROR);
    assertEquals(cameras * Math.pow(2, -cameras), expected.covered1(), ERROR);
    assertEquals(1 - Math.pow(2, -cameras), expected.chanceOfOne(0), ERROR);
  }

  /** Returns random chances, some of them 0 or 1; some targets are absent. */
  private static Chances random(int cameras, int targets, SplittableRandom random) {
    double[][] chances = new double[cameras][targets];
    for (int target = 0; target < targets; target++) {
      boolean present = random.nextInt(5) > 0;
      for (int camera = 0; camera < cameras; camera++) {
        double drawn = Math.max(0, Math.min(1, random.nextDouble(-0.3, 1.3)));
        chances[camera][target] = present ? drawn : -1;
      }
    }
    return new Chances(chances);
  }

  private static double weight(Chances chances, int outcome) {
    double weight = 1;
    for (int camera = 0; camera < chances.cameras(); camera++) {
      for (int target = 0; target < chances.targets(); target++) {
        double chance = Math.max(0, chances.values[camera][target]);
        boolean detected = (outcome >> (target * chances.cameras() + camera) & 1) != 0;
        weight *= detected ? chance : 1 - chance;
      }
    }
    return weight;
  }

  private static int covering(int outcome, int cameras, int target) {
    return Integer.bitCount(outcome >> (target * cameras) & ((1 << cameras) - 1));
  }
}
