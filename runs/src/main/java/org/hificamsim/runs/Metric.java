package org.hificamsim.runs;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** The figures of a run, each with its name in files ({@code docs/data.md}). */
@SuppressWarnings("ImmutableEnumChecker") // the figures are method references
public enum Metric {
  PERFORMANCE("performance", RunResult::performance),
  MEAN_K_MIN("mean_k_min", RunResult::meanKMin),
  COVERED_0("covered_0", RunResult::covered0),
  COVERED_1("covered_1", RunResult::covered1),
  COVERED_K("covered_k", RunResult::coveredK),
  MEAN_K("mean_k", RunResult::meanK),
  DETECTIONS("detections", RunResult::detections),
  ZOOM_CHANGES("zoom_changes", RunResult::zoomChanges),
  MESSAGES("messages", RunResult::messages),
  SCORE("score", RunResult::score),
  EXPECTED_PERFORMANCE("expected_performance", result -> result.expected().performance()),
  EXPECTED_COVERED_0("expected_covered_0", result -> result.expected().covered0()),
  EXPECTED_COVERED_1("expected_covered_1", result -> result.expected().covered1()),
  EXPECTED_COVERED_K("expected_covered_k", result -> result.expected().coveredK()),
  EXPECTED_MEAN_K("expected_mean_k", result -> result.expected().meanK()),
  LEAST_EXPECTED_K("least_expected_k", result -> result.expected().leastK()),
  LEAST_CHANCE("least_chance", result -> result.expected().leastChance()),
  LEAST_EXPECTED_K_BOUND("least_expected_k_bound", result -> result.expected().leastKBound());

  private final String label;
  private final ToDoubleFunction<RunResult> figure;

  Metric(String label, ToDoubleFunction<RunResult> figure) {
    this.label = label;
    this.figure = figure;
  }

  /** The figures that a run has, in the order of files. */
  public static List<Metric> measured(RunResult result) {
    return Arrays.stream(values()).filter(metric -> !Double.isNaN(metric.of(result))).toList();
  }

  /** Whether it is a figure of runs whose detections are by chance alone. */
  public boolean ofChance() {
    return compareTo(EXPECTED_PERFORMANCE) >= 0;
  }

  /** The name in files. */
  public String label() {
    return label;
  }

  /** The figure of one run. */
  public double of(RunResult result) {
    return figure.applyAsDouble(result);
  }
}
