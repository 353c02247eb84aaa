package org.hificamsim.core.metrics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.LongStream;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.registry.Registry;

/**
 * Scores a step and decides which configuration of a step is the best: the setting {@code
 * objective} ({@code docs/objectives.md}).
 *
 * <p>A score never falls when k rises, the number of cameras that detect a target. An objective
 * also says how configurations are compared ({@link #worths}), which part of a score a camera earns
 * ({@link #share}), and how its score is called.
 */
public sealed interface Objective {
  /** All objectives as users write them, for help. */
  String CHOICES = "kmin|covered:k=1|lexicographic|sum:cap=3";

  /** The greatest number of cameras that an option may ask for. */
  int MAX = 1_000_000;

  /** The objective as users write it, with all its options. */
  String text();

  /**
   * The score of a step.
   *
   * @param k the number of cameras that cover each target, in the entries from {@code from}
   *     (inclusive) to {@code to} (exclusive)
   * @return 0 if no target counts
   */
  double score(int[] k, int from, int to);

  /**
   * Returns the tables by which configurations are compared. Each table gives a sum over targets of
   * their worths; the first sum that differs decides.
   *
   * @param cameras the greatest number of cameras of a configuration
   * @param targets the greatest number of targets
   * @return for each sum a table of the worth of a target that k cameras detect, for k from 0 to
   *     {@code cameras}; 0 at k = 0, and never falling
   */
  List<long[]> worths(int cameras, int targets);

  /** Whether configurations are compared by the least k of a target instead of a sum. */
  default boolean byLeast() {
    return false;
  }

  /** Whether the score of a step is the least k of a target. */
  default boolean isLeast() {
    return byLeast() || countsCoverableOnly();
  }

  /**
   * An upper bound of the score.
   *
   * @param worth an upper bound of the first sum of {@link #worths}, or of the least k
   */
  default double scoreAtMost(long worth, int targets) {
    return worth;
  }

  /** Whether only targets count that some camera could detect at some view. */
  default boolean countsCoverableOnly() {
    return false;
  }

  /**
   * The part of the score that one of k cameras earns for a target: what the score would lose
   * without that camera. If the score depends on a single target, which a camera may never see, the
   * share is the difference of a harmonic sum, so that targets which few cameras detect count most.
   *
   * @param k 1 or more
   */
  default double share(int k) {
    return 1.0 / k;
  }

  /** Whether learners are rewarded by the number of targets that they detect, as in the thesis. */
  default boolean rewardsCount() {
    return false;
  }

  /** The name of the score of a step. */
  default String stepScore() {
    return "score by " + text();
  }

  /** The score of a step in words, such as "targets covered by at least one camera". */
  String words();

  /** The unit of the score of a step, in the plural; empty for a share. */
  default String unit() {
    return "cameras";
  }

  /** Whether the score of a step is a share, from 0 to 1. */
  default boolean isShare() {
    return unit().isEmpty();
  }

  /** Whether the score of a run differs from its performance (Eq 7.2). */
  default boolean hasOwnFigure() {
    return true;
  }

  /** The objective of the thesis, and the default. */
  static Objective kMin() {
    return new KMin();
  }

  /**
   * Parses an objective.
   *
   * @throws org.hificamsim.core.InputException if the name is unknown or an option is invalid
   */
  static Objective parse(String text) {
    return objectives().create(text);
  }

  /** All objectives by name. */
  static Registry<Objective> objectives() {
    return new Registry<Objective>("objective")
        .register("kmin", "the least k of a target (thesis 7.1)", KMin::new)
        .register("covered", "the share of targets that k cameras or more detect", Covered::from)
        .register(
            "lexicographic",
            "the least k of the targets that some view detects, then the next",
            Lexicographic::new)
        .register("sum", "the sum of k over the targets, none counting above cap", Sum::from);
  }

  private static double least(int[] k, int from, int to) {
    int least = from == to ? 0 : Integer.MAX_VALUE;
    for (int i = from; i < to; i++) {
      least = Math.min(least, k[i]);
    }
    return least;
  }

  /** k_min: the least k of a target (Eq 7.1). */
  record KMin() implements Objective {
    @Override
    public String text() {
      return "kmin";
    }

    @Override
    public String words() {
      return "cameras on the target with the fewest (k_min)";
    }

    @Override
    public double score(int[] k, int from, int to) {
      return least(k, from, to);
    }

    @Override
    public List<long[]> worths(int cameras, int targets) {
      return List.of(LongStream.rangeClosed(0, cameras).toArray());
    }

    @Override
    public boolean byLeast() {
      return true;
    }

    @Override
    public boolean rewardsCount() {
      return true;
    }

    @Override
    public String stepScore() {
      return "k_min";
    }

    @Override
    public boolean hasOwnFigure() {
      return false;
    }
  }

  /**
   * The share of the targets that enough cameras detect, in [0, 1].
   *
   * @param k the number of cameras that a target needs, 1 or more
   */
  record Covered(int k) implements Objective {
    private static Covered from(Options options) {
      return new Covered(options.integer("k", 1, 1, MAX, "cameras that a target needs"));
    }

    @Override
    public String text() {
      return "covered:k=" + k;
    }

    @Override
    public String words() {
      return "targets covered by at least " + (k == 1 ? "one camera" : k + " cameras");
    }

    @Override
    public String unit() {
      return "";
    }

    @Override
    public double score(int[] coverage, int from, int to) {
      int enough = 0;
      for (int i = from; i < to; i++) {
        enough += coverage[i] >= k ? 1 : 0;
      }
      return from == to ? 0 : (double) enough / (to - from);
    }

    @Override
    public List<long[]> worths(int cameras, int targets) {
      return List.of(LongStream.rangeClosed(0, cameras).map(n -> n < k ? 0 : 1).toArray());
    }

    @Override
    public double scoreAtMost(long worth, int targets) {
      return (double) worth / targets;
    }

    @Override
    public double share(int cameras) {
      return cameras == k ? 1 : 0;
    }
  }

  /**
   * The least k of the targets that some camera detects at some view.
   *
   * <p>Configurations are compared by a finer order: fewest targets with k = 0, then with k of at
   * most 1, and so on. The score is the least k only.
   */
  record Lexicographic() implements Objective {
    /** The greatest sum of the worths of all targets, with room for the arithmetic of a search. */
    private static final double MAX_SUM = 0x1p55;

    @Override
    public String text() {
      return "lexicographic";
    }

    @Override
    public String words() {
      return "cameras on the target with the fewest, of those that some view detects";
    }

    @Override
    public boolean countsCoverableOnly() {
      return true;
    }

    @Override
    public double score(int[] k, int from, int to) {
      return least(k, from, to);
    }

    /**
     * A target that reaches k = j outweighs all changes of targets above j, because the weights of
     * consecutive k differ by more than the number of targets. Each sum has as many k as fit into a
     * long.
     */
    @Override
    public List<long[]> worths(int cameras, int targets) {
      int levels = levelsThatFit(cameras, targets);
      List<long[]> worths = new ArrayList<>();
      for (int from = 0; from < Math.max(1, cameras); from += levels) {
        worths.add(falling(from, Math.min(cameras, from + levels), cameras, targets + 1L));
      }
      return worths;
    }

    private static int levelsThatFit(int cameras, int targets) {
      double base = targets + 2.0;
      double sum = (cameras + 2) * base * base;
      int fit = 1;
      for (; fit < cameras && sum * base < MAX_SUM; fit++) {
        sum *= base;
      }
      return fit;
    }

    private static long[] falling(int from, int to, int cameras, long base) {
      long[] worth = new long[cameras + 1];
      long weight = 1;
      for (int k = to; k > from; k--) {
        worth[k] = weight;
        weight *= base;
      }
      Arrays.parallelPrefix(worth, Long::sum);
      return worth;
    }

    @Override
    public double scoreAtMost(long worth, int targets) {
      return Double.POSITIVE_INFINITY;
    }
  }

  /**
   * The sum of k over the targets.
   *
   * @param cap the greatest number that a target adds, 1 or more
   */
  record Sum(int cap) implements Objective {
    private static final int DEFAULT_CAP = 3;

    private static Sum from(Options options) {
      return new Sum(
          options.integer("cap", DEFAULT_CAP, 1, MAX, "cameras of a target that count at most"));
    }

    @Override
    public String text() {
      return "sum:cap=" + cap;
    }

    @Override
    public String words() {
      return "detections, at most " + cap + " of a target";
    }

    @Override
    public String unit() {
      return "detections";
    }

    @Override
    public double score(int[] k, int from, int to) {
      long sum = 0;
      for (int i = from; i < to; i++) {
        sum += Math.min(k[i], cap);
      }
      return sum;
    }

    @Override
    public List<long[]> worths(int cameras, int targets) {
      return List.of(LongStream.rangeClosed(0, cameras).map(n -> Math.min(n, cap)).toArray());
    }

    @Override
    public double share(int k) {
      return k <= cap ? 1 : 0;
    }
  }
}
