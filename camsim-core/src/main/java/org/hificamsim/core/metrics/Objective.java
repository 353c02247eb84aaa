package org.hificamsim.core.metrics;

import org.hificamsim.core.registry.Options;
import org.hificamsim.core.registry.Registry;

/**
 * What a step is scored by, and what the best configuration of a step is: what the option {@code
 * --objective} and the attribute {@code objective} choose ({@code docs/objectives.md}).
 *
 * <p>Every score but that of {@link KMin} and {@link Lexicographic} is a sum over the targets of a
 * function of k, the number of cameras that detect the target; no score falls when a k rises.
 */
public sealed interface Objective {
  /** As users write it, with all its options. */
  String text();

  /**
   * The score of a step.
   *
   * @param k of the targets that count, from {@code from} up to, not including, {@code to}
   * @return 0 without any target
   */
  double score(int[] k, int from, int to);

  /** Whether this is the objective of the thesis. */
  default boolean isKMin() {
    return false;
  }

  /** Whether a target that no camera could detect at any view does not count. */
  default boolean ofCoverableAlone() {
    return false;
  }

  /** The objective of the thesis, and the default. */
  static Objective kMin() {
    return new KMin();
  }

  /**
   * The objective in a text.
   *
   * @throws org.hificamsim.core.InputException when it names none, or an option is wrong
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
    public boolean isKMin() {
      return true;
    }

    @Override
    public double score(int[] k, int from, int to) {
      return least(k, from, to);
    }
  }

  /**
   * The share of the targets that enough cameras detect, [0, 1].
   *
   * @param k how many cameras are enough, 1 or more
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
    public double score(int[] coverage, int from, int to) {
      int enough = 0;
      for (int i = from; i < to; i++) {
        enough += coverage[i] >= k ? 1 : 0;
      }
      return from == to ? 0 : (double) enough / (to - from);
    }
  }

  /**
   * The least k of the targets that some camera detects at some view.
   *
   * <p>Between configurations the finer order decides: fewest targets at k = 0, then at most 1, and
   * so on. The score is the least k alone.
   */
  record Lexicographic() implements Objective {
    @Override
    public String text() {
      return "lexicographic";
    }

    @Override
    public boolean ofCoverableAlone() {
      return true;
    }

    @Override
    public double score(int[] k, int from, int to) {
      return least(k, from, to);
    }
  }

  /**
   * The sum of k over the targets.
   *
   * @param cap what a target adds at most, 1 or more
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
    public double score(int[] k, int from, int to) {
      long sum = 0;
      for (int i = from; i < to; i++) {
        sum += Math.min(k[i], cap);
      }
      return sum;
    }
  }

  /** Cameras of a target that an option may ask for. */
  int MAX = 1_000_000;
}
