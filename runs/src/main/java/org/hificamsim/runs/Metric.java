package org.hificamsim.runs;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.function.BiPredicate;
import java.util.function.ToDoubleFunction;

/**
 * The metrics of a run, in the order of files. A metric is declared here alone: what it is called,
 * its unit and meaning, how it is computed, and whether {@code run} prints it. Files, tables on the
 * terminal, pages and the table in {@code docs/data.md} follow.
 */
@SuppressWarnings("ImmutableEnumChecker") // functions and records
public enum Metric {
  PERFORMANCE(
      "cameras x steps",
      "the sum of k_min over the steps (Eq 7.2)",
      measured(run -> run.coverage().performance()),
      new Line("performance", "%.0f", "sum of k_min")),
  PROPORTION_OF_OPTIMAL(
      "share",
      "the score (the performance, unless there is another [objective](objectives.md)) divided by"
          + " that of the exact optimum of the same scenario, detection model and seed; empty where"
          + " that is 0",
      compared(ScoredRun::optimum, ScoredRun::proportionOfOptimal)),
  REGRET(
      "that of `score`",
      "the optimum's score minus this one",
      compared(ScoredRun::optimum, ScoredRun::regret)),
  MEAN_K_MIN(
      "cameras",
      "performance per step",
      measured(run -> run.coverage().meanKMin()),
      new Line("mean k_min", "%.4f", "per step")),
  COVERED_0(
      "share of targets",
      "covered by no camera, over all steps (Figure 7.9)",
      measured(run -> run.coverage().proportion0()),
      new Line("covered by none", "%.4f", "share of targets")),
  COVERED_1(
      "share of targets",
      "covered by exactly one camera",
      measured(run -> run.coverage().proportion1()),
      new Line("covered by one", "%.4f", "")),
  COVERED_K(
      "share of targets",
      "covered by two or more cameras",
      measured(run -> run.coverage().proportionK()),
      new Line("covered by more", "%.4f", "")),
  MEAN_K(
      "cameras",
      "mean number of cameras that cover a target",
      measured(run -> run.coverage().meanK()),
      new Line("mean k", "%.4f", "cameras per target")),
  DETECTIONS(
      "number",
      "one for each camera, target and step",
      measured(run -> run.coverage().detections())),
  ZOOM_CHANGES(
      "number",
      "how often a camera's view (its zoom level or pan angle) differed from that of the step"
          + " before",
      measured(run -> run.coverage().zoomChanges())),
  MESSAGES(
      "number",
      "sent between cameras; [what counts](channel.md#messages-and-bits)",
      measured(run -> run.traffic().messages())),
  SCORE(
      "of `kmin` and `lexicographic`: cameras x steps; of `covered`: shares x steps; of `sum`:"
          + " detections",
      "the sum of the steps' scores by the [objective](objectives.md)",
      measured(run -> run.coverage().score())),
  SETTLING_STEPS(
      "steps",
      "until within 90% of the final level; empty where that is 0",
      compared(ScoredRun::settling)),
  UNPROVEN_STEPS(
      "steps",
      "`optimal` and `one-hop` alone: those whose search ended without a proof",
      measured(Measured::unprovenSteps)),
  PERFORMANCE_BOUND(
      "cameras x steps",
      "of the same: what the performance could have been at most",
      measured(run -> run.objective().hasOwnFigure() ? Double.NaN : run.bound())),
  SCORE_BOUND(
      "that of `score`",
      "the same of the score, under another objective than `kmin`",
      measured(run -> run.objective().hasOwnFigure() ? run.bound() : Double.NaN)),
  EXPECTED_PERFORMANCE(
      "cameras x steps",
      "[by chance](detection.md) alone, as all that are expected: before luck was drawn",
      measured(run -> run.coverage().expectedPerformance())),
  EXPECTED_COVERED_0(
      "share of targets",
      "covered by no camera, expected",
      measured(run -> run.coverage().expectedProportion0())),
  EXPECTED_COVERED_1(
      "share of targets",
      "covered by exactly one camera, expected",
      measured(run -> run.coverage().expectedProportion1())),
  EXPECTED_COVERED_K(
      "share of targets",
      "covered by two or more cameras, expected",
      measured(run -> run.coverage().expectedProportionK())),
  EXPECTED_MEAN_K(
      "cameras",
      "mean number of cameras that cover a target, expected",
      measured(run -> run.coverage().expectedMeanK())),
  LEAST_EXPECTED_K(
      "cameras",
      "the least expected number of cameras that cover a target, mean over the steps",
      measured(run -> run.coverage().leastExpectedK())),
  LEAST_CHANCE(
      "probability",
      "the least probability of a target to be covered, mean over the steps",
      measured(run -> run.coverage().leastChance())),
  LEAST_EXPECTED_K_BOUND(
      "cameras",
      "`optimal-expected` alone: what `least_expected_k` could have been at most",
      measured(Measured::leastExpectedKBound)),
  VALUE_OF_LEARNING(
      "ratio",
      "`compare` alone, of every policy but `optimal`: score over that of `best-fixed` (the best"
          + " configuration that never changes, in hindsight) of the same scenario, detection model"
          + " and seed; empty where that is 0. `zoom-out` and similar policies have it too: what"
          + " they are worth compared with a good fixed choice",
      overBestFixed(false, ScoredRun::overBestFixed)),
  BEST_FIXED(
      "that of `score`",
      "of `optimal`: the score of `best-fixed`",
      overBestFixed(true, ScoredRun::bestFixed)),
  VALUE_OF_ADAPTING(
      "ratio",
      "of `optimal`: score over that of `best-fixed`, what changing zooms is worth at most; 1 where"
          + " the optimum never needs to change",
      overBestFixed(true, ScoredRun::overBestFixed)),
  BITS("bits", "of these messages", measured(run -> run.traffic().bits())),
  MESSAGES_DROPPED(
      "number",
      "over a [channel](channel.md) that is not perfect alone: those that found no place in the"
          + " queue of their sender",
      measured(run -> run.traffic().dropped())),
  PROPORTION_OF_BOUND(
      "share",
      "with the yardstick `bound` alone: score over [a bound](objectives.md#a-bound) on the"
          + " optimum's of the same scenario, detection model and seed, so that it is at least this"
          + " share of what is possible; empty where the bound is 0",
      compared(ScoredRun::bound, ScoredRun::proportionOfBound)),
  UTILITY(
      "",
      "of CamSim's network alone, as the next five: the visibility of the targets that cameras own,"
          + " weighed by range, summed over cameras and steps",
      measured(run -> run.network().utility())),
  INVITATIONS(
      "number",
      "messages that invite a camera to bid, sent or tried; `messages` has those that arrived",
      measured(run -> run.network().counted(run.network().invitations()))),
  HANDOVERS(
      "number",
      "targets that were sold to another camera",
      measured(run -> run.network().counted(run.network().handovers()))),
  OVERLAP(
      "m2 x steps",
      "of fields of view by CamSim's formula",
      measured(run -> run.network().overlap())),
  CONFIDENCE(
      "",
      "relative confidences, summed over cameras and steps",
      measured(run -> run.network().confidence())),
  TRACKED(
      "share x steps",
      "of targets, that their owner sees",
      measured(run -> run.network().tracked())),
  ZONES_MET(
      "share",
      "of scenarios with [zones](scenario-format.md#zones) alone: how much of their cells is seen"
          + " as they ask, by weight, mean over the steps, as [`place`](placement.md) counts it",
      measured(run -> run.zones().met()),
      new Line("zones met", "%.4f", "share")),
  LEAST_ZONE_MET(
      "share",
      "the same of the zone of which least is met",
      measured(run -> run.zones().least()),
      new Line("least of a zone", "%.4f", ""));

  private static final String EXPECTED = "EXPECTED_";

  /** How a run prints a metric: its title, the format of the number, and a note. */
  private record Line(String title, String format, String note) {}

  /**
   * How a metric is computed.
   *
   * @param measured of a run alone, NaN where it has no such metric; null where others are needed
   * @param compared of a run and its reference policies; null for a metric of the run alone
   * @param applies whether a run has the metric: the optimum (true) or another
   */
  private record Source(
      ToDoubleFunction<Measured> measured,
      ToDoubleFunction<ScoredRun> compared,
      BiPredicate<ScoredRun, Boolean> applies) {}

  private final String unit;
  private final String meaning;
  private final Source source;
  private final Line line;

  Metric(String unit, String meaning, Source source) {
    this(unit, meaning, source, null);
  }

  Metric(String unit, String meaning, Source source, Line line) {
    this.unit = unit;
    this.meaning = meaning;
    this.source = source;
    this.line = line;
  }

  private static Source measured(ToDoubleFunction<Measured> figure) {
    return new Source(figure, null, (run, optimum) -> false);
  }

  private static Source compared(ToDoubleFunction<ScoredRun> figure) {
    return new Source(null, figure, (run, optimum) -> true);
  }

  /** Of a run that has a yardstick: its score is not NaN. */
  private static Source compared(
      ToDoubleFunction<ScoredRun> yardstick, ToDoubleFunction<ScoredRun> figure) {
    return new Source(null, figure, (run, optimum) -> !Double.isNaN(yardstick.applyAsDouble(run)));
  }

  private static Source overBestFixed(boolean ofOptimum, ToDoubleFunction<ScoredRun> figure) {
    return new Source(
        null, figure, (run, optimum) -> !Double.isNaN(run.bestFixed()) && optimum == ofOptimum);
  }

  /** All that a run measures on its own, each with its value. */
  static EnumMap<Metric, Double> measure(Measured run) {
    EnumMap<Metric, Double> values = new EnumMap<>(Metric.class);
    for (Metric metric : values()) {
      double value =
          metric.source.measured == null ? Double.NaN : metric.source.measured.applyAsDouble(run);
      if (!Double.isNaN(value)) {
        values.put(metric, value);
      }
    }
    return values;
  }

  /** The metrics that {@code run} prints and the page of a run shows, in the order of files. */
  public static List<Metric> ofRuns() {
    return Arrays.stream(values())
        .filter(metric -> metric.source.measured != null && !metric.isClaim())
        .toList();
  }

  /**
   * Whether a run has it, perhaps without a value.
   *
   * @param optimum whether the run is the optimum's
   */
  public boolean appliesTo(ScoredRun run, boolean optimum) {
    return source.measured == null ? source.applies.test(run, optimum) : run.result().has(this);
  }

  /** Whether it says how far the policy's claim to be the best is proven. */
  public boolean isClaim() {
    return this == UNPROVEN_STEPS || this == PERFORMANCE_BOUND || this == SCORE_BOUND;
  }

  /** The value of one run; NaN where there is none. */
  public double of(ScoredRun run) {
    return source.compared == null ? run.result().value(this) : source.compared.applyAsDouble(run);
  }

  /** The mean over runs as people read it: its interval is held to what the metric can be. */
  public Estimate shown(double[] figures) {
    Estimate mean = Estimate.mean(figures);
    double most = unit.startsWith("share") ? Math.max(1, mean.mean()) : Double.POSITIVE_INFINITY;
    return this == REGRET ? mean : mean.within(0, most);
  }

  /** The name in files. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The unit, as {@code docs/data.md} has it. */
  public String unit() {
    return unit;
  }

  /** What it is, as {@code docs/data.md} has it. */
  public String meaning() {
    return meaning;
  }

  /** Whether a run prints it. */
  public boolean isPrinted() {
    return line != null;
  }

  /** What it is called where people read: where a run prints it, and on pages. */
  public String title() {
    if (line != null) {
      return line.title;
    }
    return name().startsWith(EXPECTED)
        ? "expected " + valueOf(name().substring(EXPECTED.length())).title()
        : label().replace('_', ' ');
  }

  /** How its number is printed. */
  public String format() {
    return line.format;
  }

  /** What stands behind the printed number; perhaps nothing. */
  public String note() {
    return line.note;
  }
}
