package org.hificamsim.solver.cover;

import java.util.Arrays;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import org.hificamsim.solver.BitMatrix;
import org.hificamsim.solver.BranchAndBound;
import org.hificamsim.solver.BranchList;

/**
 * The search tree of {@link Enumeration}. A node is a plan of some cameras; its children add one
 * candidate each.
 *
 * <p>At each node, the search branches on the smaller of two sets of candidates, one of which every
 * better plan must contain:
 *
 * <ul>
 *   <li>those that add at least the average that each remaining camera must still add;
 *   <li>those that cover any of a group of points, which is so large that a better plan cannot miss
 *       all of it (set covers are branched on a single point in the same way: Etcheberry 1977).
 * </ul>
 */
final class EnumerationTree implements BranchList.Problem {
  /** The number of parts in which a group of points is chosen if more than three cameras remain. */
  private static final int GROUP_PARTS = 20;

  /** The number of parts in which a group of points is chosen if three cameras remain. */
  private static final int LAST_GROUP_PARTS = 4;

  private final BooleanSupplier stop;
  private final BitMatrix covered;
  private final BitMatrix coveringCandidates;
  private final int coverablePoints;
  private final BranchList branches;

  /** The points that can be covered and that the path does not cover, by depth. */
  private final BitMatrix uncovered;

  /** The number of points that the path covers, by depth. */
  private final int[] coveredPoints;

  /**
   * The gains of the candidates that a better plan may add, the greatest first, by depth. A branch
   * is an index into them.
   */
  private final long[][] gains;

  /** Whether a branch was tried, which excludes it, by depth and index into the gains. */
  private final boolean[][] tried;

  private final BitMatrix allowed;
  private final BitMatrix group;
  private final BitMatrix outside;
  private final int[] path;
  private int[] best;
  private int bestCovered;
  private int requiredCovered;
  private double margin;
  private boolean stopped;

  /**
   * @param start the best plan so far
   * @param cameras the number of cameras of a plan
   */
  EnumerationTree(CoverInstance instance, int[] start, int cameras, BooleanSupplier stop) {
    this.stop = stop;
    best = start;
    path = new int[cameras];
    branches = new BranchList(this, cameras);
    covered = new BitMatrix(instance.candidates(), instance.points());
    coveringCandidates = new BitMatrix(instance.points(), instance.candidates());
    uncovered = new BitMatrix(cameras + 1, instance.points());
    for (int candidate = 0; candidate < instance.candidates(); candidate++) {
      for (int point : instance.covered()[candidate]) {
        if (instance.needs()[point] > 0) {
          covered.set(candidate, point);
          coveringCandidates.set(point, candidate);
          uncovered.set(0, point);
        }
      }
    }
    coveredPoints = new int[cameras + 1];
    gains = new long[cameras + 1][];
    tried = new boolean[cameras + 1][];
    allowed = new BitMatrix(1, instance.candidates());
    group = new BitMatrix(1, instance.candidates());
    outside = new BitMatrix(1, instance.candidates());
    coverablePoints = uncovered.count(0);
    bestCovered = countCovered(start);
  }

  /** The candidates of the best plan that was found, in ascending order. */
  int[] best() {
    return best;
  }

  private int countCovered(int[] plan) {
    BitMatrix union = new BitMatrix(1, coveringCandidates.rows());
    for (int candidate : plan) {
      union.unite(0, covered, candidate);
    }
    return union.count(0);
  }

  /**
   * Searches for plans that are better by more than a margin.
   *
   * @param newMargin the margin, as a share of the points that the best plan covers
   * @return the number of points that no plan exceeds; infinite if the search was stopped
   */
  double search(double newMargin) {
    margin = newMargin;
    updateRequired();
    branches.begin();
    new BranchAndBound().search(branches, Long.MAX_VALUE);
    return stopped ? Double.POSITIVE_INFINITY : requiredCovered - 1;
  }

  private void updateRequired() {
    requiredCovered = (int) Math.floor(bestCovered * (1 + margin)) + 1;
  }

  @Override
  public void list(int depth) {
    int remaining = path.length - depth;
    coveredPoints[depth] = coverablePoints - uncovered.count(depth);
    if (coveredPoints[depth] >= requiredCovered) {
      bestCovered = coveredPoints[depth];
      best = Arrays.stream(path, 0, depth).sorted().toArray();
      updateRequired();
    }
    stopped = stopped || stop.getAsBoolean();
    if (!stopped && remaining > 0) {
      int missing = requiredCovered - coveredPoints[depth];
      gains[depth] = promisingGains(depth, remaining, missing);
      tried[depth] = new boolean[gains[depth].length];
      listSmallerSet(depth, remaining, (missing + remaining - 1) / remaining);
    }
  }

  private void listSmallerSet(int depth, int remaining, int averageMissing) {
    int aboveAverage = 0;
    while (aboveAverage < gains[depth].length
        && Gain.gain(gains[depth][aboveAverage]) >= averageMissing) {
      aboveAverage++;
    }
    boolean byGroup = remaining > 2 && countGroup(depth, remaining) < aboveAverage;
    for (int i = 0; i < (byGroup ? gains[depth].length : aboveAverage); i++) {
      if (!byGroup || group.has(0, Gain.candidate(gains[depth][i]))) {
        branches.add(i);
      }
    }
  }

  /** Gains fall from branch to branch: if one cannot lead to a better plan, none behind it can. */
  @Override
  public boolean isPromising(int depth, int branch) {
    int sum = coveredPoints[depth] + Gain.gain(gains[depth][branch]);
    int others = path.length - depth - 1;
    for (int i = 0; i < gains[depth].length && others > 0; i++) {
      if (i != branch && !tried[depth][i]) {
        sum += Gain.gain(gains[depth][i]);
        others--;
      }
    }
    return sum >= requiredCovered;
  }

  @Override
  public void take(int depth, int branch) {
    path[depth] = Gain.candidate(gains[depth][branch]);
    uncovered.setRow(depth + 1, uncovered, depth);
    uncovered.subtract(depth + 1, covered, path[depth]);
  }

  @Override
  public void undo(int depth, int branch) {
    tried[depth][branch] = true;
  }

  @Override
  public boolean isDone() {
    return stopped;
  }

  /**
   * Computes the gains of the candidates with which a plan can still add the missing points.
   *
   * @return the gains, the greatest first
   */
  private long[] promisingGains(int depth, int remaining, int missing) {
    long[] newGains = depth == 0 ? gainsOfAll() : gainsBelow(depth, remaining, missing);
    Arrays.sort(newGains);
    int count = newGains.length;
    int others = Gain.sumOfFirst(newGains, Math.min(count, remaining - 1));
    while (count > 0 && Gain.gain(newGains[count - 1]) < Math.max(1, missing - others)) {
      count--;
    }
    return Arrays.copyOf(newGains, count);
  }

  private long[] gainsOfAll() {
    return IntStream.range(0, covered.rows()).mapToLong(candidate -> gain(candidate, 0)).toArray();
  }

  private long gain(int candidate, int depth) {
    return Gain.of(covered.countCommon(candidate, uncovered, depth), candidate);
  }

  /** Gains of candidates that the node above has not tried: they only shrink from there. */
  private long[] gainsBelow(int depth, int remaining, int missing) {
    long[] above = gains[depth - 1];
    long[] newGains = new long[above.length];
    int count = 0;
    int greatest = 0;
    for (int i = 0; i < above.length; i++) {
      int limit = Gain.gain(above[i]);
      if (limit + (remaining - 1) * Math.max(greatest, limit) < missing) {
        break;
      }
      if (i != branches.taken(depth - 1) && !tried[depth - 1][i]) {
        newGains[count] = gain(Gain.candidate(above[i]), depth);
        greatest = Math.max(greatest, Gain.gain(newGains[count++]));
      }
    }
    return Arrays.copyOf(newGains, count);
  }

  /**
   * Chooses a group of points that a better plan cannot all miss, and for which few candidates
   * cover any of them, and makes these candidates the {@link #group}.
   *
   * @return the number of candidates
   */
  private int countGroup(int depth, int remaining) {
    allowed.clear(0);
    group.clear(0);
    for (long gain : gains[depth]) {
      allowed.set(0, Gain.candidate(gain));
    }
    int groupSize = coverablePoints - requiredCovered + 1;
    int[] points = uncovered.columns(depth);
    int parts = remaining > 3 ? GROUP_PARTS : LAST_GROUP_PARTS;
    for (int chosen = 0; chosen < groupSize; ) {
      outside.setRow(0, allowed, 0);
      outside.subtract(0, group, 0);
      long[] pointsByNewCandidates = new long[points.length];
      Arrays.setAll(
          pointsByNewCandidates,
          i -> ((long) coveringCandidates.countCommon(points[i], outside, 0) << 32) + points[i]);
      Arrays.sort(pointsByNewCandidates);
      chosen = chosen == 0 ? 1 : Math.min(groupSize, chosen + Math.max(1, groupSize / parts));
      for (int i = 0; i < Math.min(chosen, points.length); i++) {
        group.unite(0, coveringCandidates, (int) pointsByNewCandidates[i]);
      }
    }
    group.intersect(0, allowed, 0);
    return group.count(0);
  }

  /** Packs a gain and its candidate into a number that sorts the greatest gain first. */
  private static final class Gain {
    private Gain() {}

    static long of(int gain, int candidate) {
      return ((long) -gain << 32) + candidate;
    }

    static int gain(long number) {
      return (int) -(number >> 32);
    }

    static int candidate(long number) {
      return (int) number;
    }

    static int sumOfFirst(long[] gains, int count) {
      int sum = 0;
      for (int i = 0; i < count; i++) {
        sum += gain(gains[i]);
      }
      return sum;
    }
  }
}
