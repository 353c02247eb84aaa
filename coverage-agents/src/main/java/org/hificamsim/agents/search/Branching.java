package org.hificamsim.agents.search;

/**
 * What a search tries next: the set that helps the unsatisfied targets most against what its camera
 * could do instead, for the target with the least slack.
 */
final class Branching {
  /** Urgency of a target without slack. */
  private static final long MOST_URGENT = 1 << 20;

  private final CoverageProblem problem;
  private final Domains domains;
  private final long[] urgency;

  Branching(CoverageProblem problem, Domains domains) {
    this.problem = problem;
    this.domains = domains;
    urgency = new long[problem.mostTargets()];
  }

  /**
   * The next set to try; -1 when no target of the part is unsatisfied.
   *
   * @param parts the part to which each target belongs
   */
  int next(int[] parts, int part) {
    int target = tightest(parts, part);
    return target < 0 ? -1 : mostTelling(target);
  }

  private int tightest(int[] parts, int part) {
    int tightest = -1;
    for (int target = 0; target < problem.targets(); target++) {
      int lack = domains.lack(target);
      urgency[target] = lack > 0 ? MOST_URGENT / (domains.slack(target) + 1) : 0;
      if (lack > 0 && parts[target] == part && (tightest < 0 || tighter(target, tightest))) {
        tightest = target;
      }
    }
    return tightest;
  }

  private boolean tighter(int target, int than) {
    int difference = domains.slack(target) - domains.slack(than);
    return difference < 0 || (difference == 0 && domains.lack(target) > domains.lack(than));
  }

  private int mostTelling(int target) {
    int chosen = -1;
    long most = Long.MIN_VALUE;
    for (int i = 0; i < domains.openCameras(); i++) {
      int camera = domains.openCamera(i);
      if ((domains.undecided(camera, target >> 6) >>> target & 1) != 0) {
        int with = -1;
        long bestWith = -1;
        long bestWithout = -1;
        for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
          if (domains.alive(set)) {
            long value = value(set);
            if (!problem.contains(set, target)) {
              bestWithout = Math.max(bestWithout, value);
            } else if (value > bestWith) {
              bestWith = value;
              with = set;
            }
          }
        }
        if (bestWith - bestWithout > most) {
          most = bestWith - bestWithout;
          chosen = with;
        }
      }
    }
    return chosen;
  }

  private long value(int set) {
    long value = 0;
    for (int word = 0; word < problem.words(); word++) {
      for (long bits = problem.mask(set, word); bits != 0; bits &= bits - 1) {
        value += urgency[(word << 6) + Long.numberOfTrailingZeros(bits)];
      }
    }
    return value;
  }
}
