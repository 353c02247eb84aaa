package org.hificamsim.runs.compare;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.output.Column;
import org.hificamsim.runs.output.Table;
import org.hificamsim.runs.statistics.Aggregate;
import org.hificamsim.runs.statistics.PairedTest;

/** The tables over all scenarios of a comparison, and those of pairs of policies. */
public final class AggregateFiles {
  private static final List<Column<PolicyScores>> POLICY =
      Table.<PolicyScores>of("")
          .texts("detection", "the detection's name", PolicyScores::detection)
          .texts("policy", "the zoom policy with its options", PolicyScores::policy)
          .columns();
  private static final String OTHER = "the policy that it is compared with";

  private static final String MEASURE =
      "what is compared: `proportion_of_optimal`; without the optimum as a yardstick"
          + " `proportion_of_bound`, else `value_of_learning`, else `score`";

  /** Two policies under one detection, over the same scenarios. */
  record PolicyPair(PolicyScores one, PolicyScores other) {
    /**
     * The two in one scenario.
     *
     * @param metric whose differences are looked at
     */
    record InScenario(CaseResult one, CaseResult other, Metric metric) {
      /** What the first has more than the other, by seed, where both have a value. */
      double[] differences() {
        return Estimate.differences(one.figures(metric), other.figures(metric));
      }
    }

    /** Each pair once, the policy that was asked for first before the other. */
    static List<PolicyPair> of(List<PolicyScores> policies) {
      List<PolicyPair> pairs = new ArrayList<>();
      for (int i = 0; i < policies.size(); i++) {
        for (PolicyScores other : policies.subList(i + 1, policies.size())) {
          if (other.detection().equals(policies.get(i).detection())) {
            pairs.add(new PolicyPair(policies.get(i), other));
          }
        }
      }
      return pairs;
    }

    /** The pair scenario by scenario. */
    List<InScenario> inScenarios() {
      return IntStream.range(0, one.cases().size())
          .mapToObj(i -> new InScenario(one.cases().get(i), other.cases().get(i), one.metric()))
          .toList();
    }
  }

  /** A statistic of a policy. */
  record Statistic(PolicyScores of, Aggregate aggregate, Estimate value) {}

  /** A point of a policy's profile. */
  record Point(PolicyScores of, double tau, Estimate share) {}

  /** How a policy does against another. */
  record Against(PolicyPair pair, Estimate probability) {}

  /** A pair in one scenario, with its p-value before and after Holm's correction. */
  record Difference(PolicyPair.InScenario pair, Estimate mean, double p, double corrected) {}

  /** A row per detection, policy and statistic. */
  public static final Table<Statistic> AGGREGATE =
      Table.<Statistic>of("aggregate.csv")
          .with(POLICY, Statistic::of)
          .texts(
              "statistic",
              "`iqm`, `optimality_gap`, `mean` or `median`",
              row -> row.aggregate.label())
          .ints("scenarios", "", "how many have a value", row -> row.of.scores().scenarios())
          .ints("runs", "", "how many have a value", row -> row.of.scores().runs())
          .estimates("value", "", "share", "of `metric`", Statistic::value)
          .texts("metric", MEASURE, row -> row.of.metric().label());

  /** A row per detection, policy and tau. */
  public static final Table<Point> PROFILE =
      Table.<Point>of("profile.csv")
          .with(POLICY, Point::of)
          .doubles("tau", "share", "0 to 1 in hundredths", Point::tau)
          .estimates(
              "share",
              "",
              "share",
              "of runs whose proportion of the optimum (`metric` of `aggregate.csv`) is `tau` or"
                  + " more",
              Point::share);

  /** A row per detection and pair of policies. */
  public static final Table<Against> IMPROVEMENT =
      Table.<Against>of("improvement.csv")
          .with(POLICY, row -> row.pair.one())
          .texts("other", OTHER, row -> row.pair.other().policy())
          .ints(
              "scenarios", "", "how many have a value", row -> row.pair.one().scores().scenarios())
          .estimates(
              "probability",
              "",
              "probability",
              "that a run of `policy` has a higher proportion than a run of `other` in the same"
                  + " scenario (a tie counts half; the mean over scenarios)",
              Against::probability);

  /** A row per scenario, detection and pair of policies. */
  public static final Table<Difference> PAIRS =
      Table.<Difference>of("pairs.csv")
          .with(ComparisonFiles.CASE, row -> row.pair.one().plan())
          .texts("other", OTHER, row -> row.pair.other().plan().policy())
          .texts("metric", MEASURE, row -> row.pair.metric().label())
          .ints("runs", "", "seeds with a value", row -> row.pair.differences().length)
          .estimates(
              "difference", "", "share", "`policy` minus `other`, paired by seed", Difference::mean)
          .doubles(
              "p_value",
              "probability",
              "two-sided randomization test: each difference might as well have the other sign; all"
                  + " choices of signs up to 16 seeds, 99,999 drawn ones above",
              Difference::p)
          .doubles(
              "p_holm",
              "probability",
              "the same after Holm's correction over all rows of the file: below 0.05, not one"
                  + " false finding in all of it is likely",
              Difference::corrected);

  private AggregateFiles() {}

  /**
   * Adds the tables to a folder's.
   *
   * @param cases every policy under every detection in every scenario
   * @param threads that share the work, 1 or more: an interval takes thousands of draws
   */
  public static void write(OutputFolder folder, List<CaseResult> cases, int threads)
      throws IOException {
    List<PolicyScores> policies = PolicyScores.of(cases);
    List<PolicyPair> pairs = PolicyPair.of(policies);
    if (Yardstick.of(cases).isPresent()) { // scores themselves are no shares of anything
      List<List<Statistic>> statistics =
          Parallel.map(policies, threads, AggregateFiles::statistics);
      AGGREGATE.write(folder, statistics.stream().flatMap(List::stream));
      List<List<Point>> points = Parallel.map(policies, threads, AggregateFiles::points);
      PROFILE.write(folder, points.stream().flatMap(List::stream));
    }
    List<Against> improvements = Parallel.map(pairs, threads, AggregateFiles::against);
    IMPROVEMENT.write(folder, improvements.stream());
    PAIRS.write(folder, differences(pairs, threads));
  }

  private static List<Statistic> statistics(PolicyScores one) {
    Map<Aggregate, Estimate> estimates = Aggregate.estimates(one.scores());
    return Stream.of(Aggregate.values())
        .map(aggregate -> new Statistic(one, aggregate, estimates.get(aggregate)))
        .toList();
  }

  private static List<Point> points(PolicyScores one) {
    Estimate[] shares = Aggregate.profile(one.scores());
    return IntStream.range(0, shares.length)
        .mapToObj(i -> new Point(one, Aggregate.TAUS[i], shares[i]))
        .toList();
  }

  private static Against against(PolicyPair pair) {
    return new Against(pair, Aggregate.improvement(pair.one().scores(), pair.other().scores()));
  }

  /** Holm's correction is over all rows. */
  private static Stream<Difference> differences(List<PolicyPair> pairs, int threads) {
    List<PolicyPair.InScenario> all =
        pairs.stream().flatMap(pair -> pair.inScenarios().stream()).toList();
    double[] p =
        Parallel.map(all, threads, pair -> PairedTest.p(pair.differences())).stream()
            .mapToDouble(Double::doubleValue)
            .toArray();
    double[] corrected = PairedTest.corrected(p);
    return IntStream.range(0, p.length)
        .mapToObj(
            i ->
                new Difference(
                    all.get(i), Estimate.mean(all.get(i).differences()), p[i], corrected[i]));
  }
}
