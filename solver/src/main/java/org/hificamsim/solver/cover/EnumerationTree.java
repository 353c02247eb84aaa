package org.hificamsim.solver.cover;

import java.util.Arrays;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

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
final class EnumerationTree {
  /** The number of parts in which a group of points is chosen if more than three cameras remain. */
  private static final int GROUP_PARTS = 20;

  /** The number of parts in which a group of points is chosen if three cameras remain. */
  private static final int LAST_GROUP_PARTS = 4;

  private final BooleanSupplier stop;
  private final BitRows covered;
  private final BitRows coveringCandidates;
  private final int coverablePoints;
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
    covered = new BitRows(instance.candidates(), instance.points());
    coveringCandidates = new BitRows(instance.points(), instance.candidates());
    for (int candidate = 0; candidate < instance.candidates(); candidate++) {
      for (int point : instance.covered()[candidate]) {
        if (instance.needs()[point] > 0) {
          covered.set(candidate, point);
          coveringCandidates.set(point, candidate);
        }
      }
    }
    coverablePoints = Bits.count(uncovered(new int[0]));
    bestCovered = coverablePoints - Bits.count(uncovered(start));
  }

  /** The candidates of the best plan that was found, in ascending order. */
  int[] best() {
    return best;
  }

  /** The points that can be covered, and are not covered by a plan. */
  private long[] uncovered(int[] plan) {
    long[] uncovered = Bits.none(coveringCandidates.rows());
    for (int point = 0; point < coveringCandidates.rows(); point++) {
      if (Bits.count(coveringCandidates.row(point)) > 0) {
        Bits.set(uncovered, point);
      }
    }
    for (int candidate : plan) {
      uncovered = Bits.without(uncovered, covered.row(candidate));
    }
    return uncovered;
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
    long[] gains =
        IntStream.range(0, covered.rows())
            .mapToLong(candidate -> Gain.of(coverablePoints, candidate))
            .toArray();
    extend(uncovered(new int[0]), gains, 0);
    return stopped ? Double.POSITIVE_INFINITY : requiredCovered - 1;
  }

  private void updateRequired() {
    requiredCovered = (int) Math.floor(bestCovered * (1 + margin)) + 1;
  }

  /**
   * Searches all plans that extend the path.
   *
   * @param uncovered the points that the path does not cover
   * @param parentGains the gains of the allowed candidates at the parent node, the greatest first
   * @param depth the number of candidates on the path
   */
  private void extend(long[] uncovered, long[] parentGains, int depth) {
    int remaining = path.length - depth;
    int coveredPoints = coverablePoints - Bits.count(uncovered);
    if (coveredPoints >= requiredCovered) {
      bestCovered = coveredPoints;
      best = Arrays.stream(path, 0, depth).sorted().toArray();
      updateRequired();
    }
    stopped = stopped || stop.getAsBoolean();
    if (stopped || remaining == 0) {
      return;
    }
    int missing = requiredCovered - coveredPoints;
    long[] gains = gains(uncovered, parentGains, remaining, missing);
    int averageMissing = (missing + remaining - 1) / remaining;
    int aboveAverage = 0;
    while (aboveAverage < gains.length && Gain.gain(gains[aboveAverage]) >= averageMissing) {
      aboveAverage++;
    }
    long[] group = remaining > 2 ? groupCandidates(uncovered, gains, remaining) : new long[0];
    if (remaining > 2 && Bits.count(group) < aboveAverage) {
      branchOnGroup(uncovered, gains, group, depth);
    } else {
      branchOnFirst(uncovered, gains, aboveAverage, depth);
    }
  }

  /** Branches on the first candidates; each excludes those before it from its subtree. */
  private void branchOnFirst(long[] uncovered, long[] gains, int count, int depth) {
    int coveredPoints = coverablePoints - Bits.count(uncovered);
    for (int i = 0; i < count; i++) {
      long[] rest = Arrays.copyOfRange(gains, i + 1, gains.length);
      if (!canReach(coveredPoints, gains[i], rest, depth)) {
        return;
      }
      branch(uncovered, gains[i], rest, depth);
    }
  }

  /** Branches on the candidates of a group; each excludes those tried before from its subtree. */
  private void branchOnGroup(long[] uncovered, long[] gains, long[] group, int depth) {
    int coveredPoints = coverablePoints - Bits.count(uncovered);
    boolean[] tried = new boolean[gains.length];
    for (int i = 0; i < gains.length; i++) {
      if (Bits.has(group, Gain.candidate(gains[i]))) {
        tried[i] = true;
        long[] rest = untried(gains, tried);
        if (!canReach(coveredPoints, gains[i], rest, depth)) {
          return;
        }
        branch(uncovered, gains[i], rest, depth);
      }
    }
  }

  /**
   * Whether plans with a candidate can be better. If not, this is also false for all candidates
   * that follow it, which gain less.
   */
  private boolean canReach(int coveredPoints, long gain, long[] rest, int depth) {
    int others = Gain.sumOfFirst(rest, path.length - depth - 1);
    return coveredPoints + Gain.gain(gain) + others >= requiredCovered;
  }

  private void branch(long[] uncovered, long gain, long[] rest, int depth) {
    int candidate = Gain.candidate(gain);
    path[depth] = candidate;
    extend(Bits.without(uncovered, covered.row(candidate)), rest, depth + 1);
  }

  private static long[] untried(long[] gains, boolean[] tried) {
    return IntStream.range(0, gains.length)
        .filter(i -> !tried[i])
        .mapToLong(i -> gains[i])
        .toArray();
  }

  /**
   * Computes the gains of the candidates with which a plan can still add the missing points.
   *
   * @return the gains, the greatest first
   */
  private long[] gains(long[] uncovered, long[] parentGains, int remaining, int missing) {
    long[] gains = new long[parentGains.length];
    int count = 0;
    int greatest = 0;
    for (long parentGain : parentGains) {
      int limit = Gain.gain(parentGain); // gains only shrink from parent to child
      if (limit + (remaining - 1) * Math.max(greatest, limit) < missing) {
        break;
      }
      int candidate = Gain.candidate(parentGain);
      int gain = Bits.countCommon(covered.row(candidate), uncovered);
      greatest = Math.max(greatest, gain);
      gains[count++] = Gain.of(gain, candidate);
    }
    Arrays.sort(gains, 0, count);
    long[] greatestGains = Arrays.copyOf(gains, Math.min(count, remaining - 1));
    int others = Gain.sumOfFirst(greatestGains, remaining - 1);
    while (count > 0 && Gain.gain(gains[count - 1]) < Math.max(1, missing - others)) {
      count--;
    }
    return Arrays.copyOf(gains, count);
  }

  /**
   * Chooses a group of points that a better plan cannot all miss, and for which few candidates
   * cover any of them, and returns these candidates.
   */
  private long[] groupCandidates(long[] uncovered, long[] gains, int remaining) {
    long[] allowed = Bits.none(covered.rows());
    for (long gain : gains) {
      Bits.set(allowed, Gain.candidate(gain));
    }
    int groupSize = coverablePoints - requiredCovered + 1;
    int[] points = Bits.members(uncovered);
    long[] group = Bits.none(covered.rows());
    int parts = remaining > 3 ? GROUP_PARTS : LAST_GROUP_PARTS;
    for (int chosen = 0; chosen < groupSize; ) {
      long[] outside = Bits.without(allowed, group);
      long[] pointsByNewCandidates = new long[points.length];
      Arrays.setAll(
          pointsByNewCandidates,
          i ->
              ((long) Bits.countCommon(coveringCandidates.row(points[i]), outside) << 32)
                  + points[i]);
      Arrays.sort(pointsByNewCandidates);
      chosen = chosen == 0 ? 1 : Math.min(groupSize, chosen + Math.max(1, groupSize / parts));
      for (int i = 0; i < Math.min(chosen, points.length); i++) {
        long[] covering = coveringCandidates.row((int) pointsByNewCandidates[i]);
        Arrays.setAll(group, word -> group[word] | (covering[word] & allowed[word]));
      }
    }
    return group;
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
      for (int i = 0; i < Math.min(count, gains.length); i++) {
        sum += gain(gains[i]);
      }
      return sum;
    }
  }
}
