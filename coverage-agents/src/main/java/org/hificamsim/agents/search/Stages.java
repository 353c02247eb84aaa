package org.hificamsim.agents.search;

import java.util.Arrays;
import org.hificamsim.core.metrics.Objective;

/**
 * An objective as one {@link Worth} after the other: a choice is better by the first one that
 * differs. All but {@code lexicographic} have one.
 *
 * <p>{@code lexicographic} minimises the targets with k = 0, then those with k up to 1, and so on:
 * a sum with weights that fall so steeply that a target more at one k outweighs all that follow. As
 * many k as fit into a long are weighed in one stage.
 */
final class Stages {
  private static final int MAX_STAGES = 8;
  private static final double MAX = 0x1p62;

  private final Objective objective;
  private final CoverageProblem problem;
  private final Decisions decisions;
  private final ValueBounds[] bounds;
  private final int[] k;
  private final int[] supply;
  private int levels;
  private int most; // the highest k of a target

  Stages(Objective objective, CoverageProblem problem, Decisions decisions) {
    this.objective = objective;
    this.problem = problem;
    this.decisions = decisions;
    bounds = new ValueBounds[objective instanceof Objective.Lexicographic ? MAX_STAGES : 1];
    Arrays.setAll(
        bounds, stage -> new ValueBounds(problem, decisions, new Worth(problem.maxCameras())));
    k = new int[problem.maxTargets()];
    supply = new int[problem.maxTargets()];
    fill(objective);
  }

  ValueBounds[] bounds() {
    return bounds;
  }

  /** The worths that are the same for all problems. */
  private void fill(Objective objective) {
    if (objective instanceof Objective.Covered covered) {
      bounds[0].worth().whereCovered(covered.k());
    } else if (objective instanceof Objective.Sum sum) {
      bounds[0].worth().ofEachUpTo(sum.cap());
    }
  }

  /** Fits the worths to the problem, whose cameras are all open; returns how many count. */
  int fill() {
    int highest = 1;
    for (int target = 0; target < problem.targets(); target++) {
      supply[target] = decisions.supply(target);
      highest = Math.max(highest, supply[target]);
    }
    most = highest;
    return objective instanceof Objective.Lexicographic ? weigh(highest) : 1;
  }

  private int weigh(int highest) {
    levels = Math.min(highest, levelsThatFit());
    int count = Math.min(MAX_STAGES, (highest + levels - 1) / levels);
    for (int stage = 0; stage < count; stage++) {
      int from = stage * levels;
      bounds[stage].worth().falling(from, Math.min(levels, highest - from), problem.targets() + 1L);
    }
    return count;
  }

  /** So that sums over all cameras and targets stay below 2^62. */
  private int levelsThatFit() {
    double base = Math.max(2, problem.targets() + 1); // without a target nothing is outweighed
    double sum = (problem.cameras() + 2.0) * base * base;
    int fit = 1;
    while (sum * base < MAX) {
      sum *= base;
      fit++;
    }
    return fit;
  }

  /** Whether so many stages decide about a choice with this score: none is cut off below it. */
  boolean decide(int count, double score) {
    return !(objective instanceof Objective.Lexicographic)
        || (long) count * levels >= most
        || score < (double) count * levels;
  }

  /** The score of a choice. */
  double score(Choice choice) {
    return objective.score(k, 0, collect(choice));
  }

  /** Collects k of the targets that count. */
  private int collect(Choice choice) {
    int count = 0;
    for (int target = 0; target < problem.targets(); target++) {
      if (!objective.ofCoverableAlone() || supply[target] > 0) {
        k[count++] = choice.coverage(target);
      }
    }
    return count;
  }

  /**
   * What no choice's score exceeds where all stages before this one are proven.
   *
   * @param most of what this stage's worth can come to
   */
  double bound(int stage, long most, Choice choice) {
    long bound = most / bounds[stage].worth().step();
    if (objective instanceof Objective.Covered) {
      return (double) bound / problem.targets();
    } else if (objective instanceof Objective.Sum) {
      return bound;
    }
    double least = score(choice);
    return least < stage * levels ? least : leastSupply();
  }

  private int leastSupply() {
    int least = problem.cameras();
    for (int target = 0; target < problem.targets(); target++) {
      least = supply[target] > 0 ? Math.min(least, supply[target]) : least;
    }
    return least;
  }
}
