package org.hificamsim.runs;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;

/**
 * The metrics of a run, in the order of files. A metric is declared only here: its name, unit and
 * meaning, how it is computed, and whether {@code run} prints it. Files, tables on the terminal,
 * pages and the table in {@code docs/data.md} follow.
 */
@SuppressWarnings("ImmutableEnumChecker") // functions and records
public enum Metric {
  PERFORMANCE(
      "cameras x steps",
      "the sum of k_min over the steps (Eq 7.2)",
      measured(run -> run.coverage().performance()),
      new Line("summed k_min", "%.0f", "cameras x steps")),
  PROPORTION_OF_OPTIMAL(
      "share",
      "the score (the performance, unless there is another [objective](objectives.md)) divided by"
          + " that of the exact optimum of the same scenario, detection model and seed; empty where"
          + " that is 0",
      compared(ScoreComparison::optimum, ScoreComparison::proportionOfOptimal)),
  REGRET(
      "that of `score`",
      "the optimum's score minus this one",
      compared(ScoreComparison::optimum, ScoreComparison::regret)),
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
      measured(run -> run.coverage().moves().viewChanges())),
  MESSAGES(
      "number",
      "sent between cameras; [what counts](channel.md#messages-and-bits)",
      measured(run -> run.traffic().messages())),
  SCORE(
      "of `kmin` and `lexicographic`: cameras x steps; of `covered`: shares x steps; of `sum`:"
          + " detections",
      "the sum of the steps' scores by the [objective](objectives.md)",
      measured(run -> run.coverage().score()),
      new Line("summed score", "%.3f", "")),
  SETTLING_STEPS(
      "steps",
      "until within 90% of the final level; empty where that is 0",
      compared(ScoreComparison::settling)),
  UNPROVEN_STEPS(
      "steps",
      "`optimal` and `one-hop` alone: steps whose search ended without a proof",
      measured(Measured::unprovenSteps)),
  PERFORMANCE_BOUND(
      "cameras x steps",
      "`optimal` and `one-hop` alone: the most that the performance could have been",
      measured(run -> run.objective().hasOwnFigure() ? Double.NaN : run.bound())),
  SCORE_BOUND(
      "that of `score`",
      "`optimal` and `one-hop` under another objective than `kmin` alone: the most that the score"
          + " could have been",
      measured(run -> run.objective().hasOwnFigure() ? run.bound() : Double.NaN)),
  EXPECTED_PERFORMANCE(
      "cameras x steps",
      "performance, expected before luck is drawn; like all expected metrics, of detections [by"
          + " chance](detection.md) alone",
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
      overBestFixed(false, ScoreComparison::overBestFixed)),
  BEST_FIXED(
      "that of `score`",
      "of `optimal`: the score of `best-fixed`",
      overBestFixed(true, ScoreComparison::bestFixed)),
  VALUE_OF_ADAPTING(
      "ratio",
      "of `optimal`: score over that of `best-fixed`, what changing zooms is worth at most; 1 where"
          + " the optimum never needs to change",
      overBestFixed(true, ScoreComparison::overBestFixed)),
  BITS("bits", "size of all `messages`", measured(run -> run.traffic().bits())),
  MESSAGES_DROPPED(
      "number",
      "over an imperfect [channel](channel.md) alone: messages that were dropped because the queue"
          + " of their sender was full",
      measured(run -> run.traffic().dropped())),
  PROPORTION_OF_BOUND(
      "share",
      "with the yardstick `bound` alone: score over [a bound](objectives.md#a-bound) on the"
          + " optimum's of the same scenario, detection model and seed, so that it is at least this"
          + " share of what is possible; empty where the bound is 0",
      compared(ScoreComparison::bound, ScoreComparison::proportionOfBound)),
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
      "targets that were sold to another camera; without CamSim's network, of runs that"
          + " [follow targets](following.md) alone, that passed from one camera to another without"
          + " a gap",
      measured(Measured::handovers)),
  OVERLAP(
      "m2 x steps",
      "overlap of fields of view by CamSim's formula",
      measured(run -> run.network().overlap())),
  CONFIDENCE(
      "",
      "relative confidences, summed over cameras and steps",
      measured(run -> run.network().confidence())),
  TRACKED(
      "share x steps",
      "share of targets that their owner sees, summed over steps",
      measured(run -> run.network().tracked())),
  ZONES_MET(
      "share",
      "of scenarios with [zones](scenario-format.md#zones) alone: how much of their cells is seen"
          + " as they ask, by weight, mean over the steps, as [`place`](placement.md) counts it",
      measured(run -> run.zones().met()),
      new Line("zones met", "%.4f", "share")),
  LEAST_ZONE_MET(
      "share",
      "`zones_met` of the zone with the smallest share",
      measured(run -> run.zones().least()),
      new Line("least of a zone", "%.4f", "")),
  ENERGY(
      "J",
      "of scenarios with [energy](energy.md) alone, as the next four: what all cameras took",
      measured(run -> run.energy().joules()),
      new Line("energy", "%.6g", "J")),
  LIFETIME_FIRST(
      "steps",
      "until the first battery was empty; empty where none is",
      measured(run -> run.energy().firstEmpty()),
      new Line("first battery empty", "%.0f", "steps")),
  LIFETIME_HALF(
      "steps",
      "until half the batteries were empty",
      measured(run -> run.energy().halfEmpty()),
      new Line("half of them empty", "%.0f", "steps")),
  COVERED_UNTIL_FIRST(
      "share of targets",
      "covered by any camera, over the steps until the first battery was empty",
      measured(run -> run.energy().coveredUntilFirst())),
  COVERED_UNTIL_HALF(
      "share of targets",
      "covered by any camera, over the steps until half the batteries were empty",
      measured(run -> run.energy().coveredUntilHalf())),
  TIME_TO_FIND(
      "steps",
      "of runs that [follow targets](following.md) alone, as the next five: from the appearance of"
          + " a target until a camera first covers it, mean",
      measured(run -> run.following().stepsToFind()),
      new Line("found after", "%.4g", "steps")),
  TIME_TO_FIND_AGAIN(
      "steps",
      "from the loss of a target until a camera covers it again, mean over the losses that ended",
      measured(run -> run.following().stepsToFindAgain()),
      new Line("found again in", "%.4g", "steps")),
  LOSSES(
      "number",
      "how often a target that was still there was no longer covered by any camera",
      measured(run -> run.following().losses())),
  ENDED_LOSSES(
      "number",
      "losses after which a camera covered the target again",
      measured(run -> run.following().endedLosses())),
  UNBROKEN(
      "share",
      "the longest time for which a target was covered without a gap, of the time for which it was"
          + " there, mean over targets",
      measured(run -> run.following().unbroken()),
      new Line("without a gap", "%.4f", "share of a target's time")),
  IDENTITY_SWITCHES(
      "number",
      "of policies that [tell targets apart](cooperation.md#in-each-step) by tracks of their own"
          + " alone: how often a target was taken for another one",
      measured(Measured::identitySwitches)),
  ZOOM_CHANGE_RATE(
      "per camera and step",
      "`zoom_changes` for each camera and step in which it is online",
      measured(run -> run.coverage().moves().viewChangeRate()),
      new Line("zoom change rate", "%.4f", "per camera and step")),
  PAN_TRAVEL(
      "degrees per camera and step",
      "how far cameras turned, either way; where turning takes time, only the part that they"
          + " completed counts",
      measured(run -> run.coverage().moves().meanPanTravel()),
      new Line("pan travel", "%.4g", "degrees per camera and step")),
  ZOOM_TRAVEL(
      "levels per camera and step",
      "how far lenses changed, in zoom levels",
      measured(run -> run.coverage().moves().meanZoomTravel()),
      new Line("zoom travel", "%.4g", "levels per camera and step")),
  REACHABLE_BOUND(
      "that of `score`",
      "`reachable` alone: the score that no policy exceeds, with the time that moves take",
      measured(Measured::reachableBound)),
  PROPORTION_OF_REACHABLE(
      "share",
      "with the yardstick `reachable` alone: score over [the bound](policies.md#reachable) on what"
          + " cameras could have scored in time, of the same scenario, detection model and seed;"
          + " empty where the bound is 0",
      compared(ScoreComparison::reachableBound, ScoreComparison::proportionOfReachable)),
  MEAN_SCORE(
      "of `kmin` and `lexicographic`: cameras; of `covered`: share; of `sum`: detections",
      "the mean of the steps' scores by the [objective](objectives.md): `score` per step",
      measured(run -> run.coverage().meanScore()));

  private static final String EXPECTED = "EXPECTED_";

  /** A metric as a run prints it: its title, the format of the number, and a note. */
  private record Line(String title, String format, String note) {}

  private final String unit;
  private final String meaning;
  private final MetricSource source;
  private final Line line;

  Metric(String unit, String meaning, MetricSource source) {
    this(unit, meaning, source, null);
  }

  Metric(String unit, String meaning, MetricSource source, Line line) {
    this.unit = unit;
    this.meaning = meaning;
    this.source = source;
    this.line = line;
  }

  private static MetricSource measured(ToDoubleFunction<Measured> value) {
    return new MetricSource.RunAlone(value);
  }

  private static MetricSource compared(ToDoubleFunction<ScoreComparison> value) {
    return new MetricSource.Compared(value, (scores, isOptimum) -> true);
  }

  /** Computes a metric of runs whose comparison has a yardstick, the score of which is not NaN. */
  private static MetricSource compared(
      ToDoubleFunction<ScoreComparison> yardstick, ToDoubleFunction<ScoreComparison> value) {
    return new MetricSource.Compared(
        value, (scores, isOptimum) -> !Double.isNaN(yardstick.applyAsDouble(scores)));
  }

  private static MetricSource overBestFixed(
      boolean forOptimum, ToDoubleFunction<ScoreComparison> value) {
    return new MetricSource.Compared(
        value, (scores, isOptimum) -> !Double.isNaN(scores.bestFixed()) && isOptimum == forOptimum);
  }

  /** The values of all metrics that a run has on its own. */
  static EnumMap<Metric, Double> measure(Measured run) {
    EnumMap<Metric, Double> values = new EnumMap<>(Metric.class);
    for (Metric metric : values()) {
      if (metric.source instanceof MetricSource.RunAlone source) {
        double value = source.value().applyAsDouble(run);
        if (!Double.isNaN(value)) {
          values.put(metric, value);
        }
      }
    }
    return values;
  }

  /** The metrics that {@code run} prints and the page of a run shows, in the order of files. */
  public static List<Metric> ofRuns() {
    return Arrays.stream(values()).filter(metric -> metric.isOfRun() && !metric.isClaim()).toList();
  }

  /** Whether a run is enough to compute the metric; else it needs a comparison's yardsticks. */
  boolean isOfRun() {
    return source instanceof MetricSource.RunAlone;
  }

  /** Whether a run of a comparison has the metric, perhaps without a value. */
  boolean appliesTo(ScoreComparison scores, boolean isOptimum) {
    return ((MetricSource.Compared) source).applies().test(scores, isOptimum);
  }

  /** The value from a comparison; NaN if there is none. */
  double valueFrom(ScoreComparison scores) {
    return ((MetricSource.Compared) source).value().applyAsDouble(scores);
  }

  /** Whether the metric says how far the policy's claim to be the best is proven. */
  public boolean isClaim() {
    return this == UNPROVEN_STEPS || this == PERFORMANCE_BOUND || this == SCORE_BOUND;
  }

  /** The mean over the runs of a plan, with its interval cut to what is possible. */
  public Estimate mean(RunPlan plan, double[] values) {
    return MetricRange.cut(this, plan, Estimate.mean(values));
  }

  /** The name in files. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The unit, as {@code docs/data.md} has it. */
  public String unit() {
    return unit;
  }

  /** The meaning, as {@code docs/data.md} has it. */
  public String meaning() {
    return meaning;
  }

  /** Whether {@code run} prints the metric. */
  public boolean isPrinted() {
    return line != null;
  }

  /** The name for people, on the terminal and on pages. */
  public String title() {
    if (line != null) {
      return line.title;
    }
    return name().startsWith(EXPECTED)
        ? "expected " + valueOf(name().substring(EXPECTED.length())).title()
        : label().replace('_', ' ').replace("performance", PERFORMANCE.title());
  }

  /** The format of the printed number. */
  public String format() {
    return line.format;
  }

  /** A note after the printed number; may be empty. */
  public String note() {
    return line.note;
  }
}
