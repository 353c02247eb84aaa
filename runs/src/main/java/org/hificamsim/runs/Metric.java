package org.hificamsim.runs;

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
  MESSAGES("messages", RunResult::messages);

  private final String label;
  private final ToDoubleFunction<RunResult> figure;

  Metric(String label, ToDoubleFunction<RunResult> figure) {
    this.label = label;
    this.figure = figure;
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
