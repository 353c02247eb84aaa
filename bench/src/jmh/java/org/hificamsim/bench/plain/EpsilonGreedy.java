package org.hificamsim.bench.plain;

import java.util.Random;

/**
 * The bandit of thesis 7.4.3, which chooses the level that detected most on average, and now and
 * then another one.
 */
final class EpsilonGreedy implements LevelPolicy {
  private final double epsilon;
  private final Random random;
  private final double[] means;
  private final int[] uses;

  EpsilonGreedy(int levels, double epsilon, Random random) {
    this.epsilon = epsilon;
    this.random = random;
    this.means = new double[levels];
    this.uses = new int[levels];
  }

  @Override
  public int choose(int level, int detected) {
    return explore(best(means), means.length, epsilon, random);
  }

  @Override
  public void learn(int level, int detected) {
    uses[level]++;
    means[level] += (detected - means[level]) / uses[level];
  }

  /** Returns the widest of the levels with the largest value. */
  static int best(double[] values) {
    int best = 0;
    for (int level = 1; level < values.length; level++) {
      if (values[level] >= values[best]) {
        best = level;
      }
    }
    return best;
  }

  /** Returns the best level or, with probability epsilon, one of the others. */
  static int explore(int best, int levels, double epsilon, Random random) {
    if (random.nextDouble() >= epsilon) {
      return best;
    }
    int other = random.nextInt(levels - 1);
    return other < best ? other : other + 1;
  }
}
