package org.hificamsim.runs.compare;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.output.Column;
import org.hificamsim.runs.output.Table;
import org.hificamsim.runs.statistics.Aggregate;
import org.hificamsim.runs.statistics.PairedTest;

/** Writes the tables over all scenarios of a comparison, and those of pairs of policies. */
public final class AggregateFiles {
  private static final List<Column<PolicyScores>> POLICY =
      Table.<PolicyScores>of("")
          .texts("detection", "the detection's name", PolicyScores::detection)
          .texts("policy", "the zoom policy with its options", PolicyScores::policy)
          .columns();
  private static final String OTHER = "the policy that `policy` is compared with";

  private static final String MEASURE =
      "what is compared: `proportion_of_optimal`; without the optimum as a yardstick"
          + " `proportion_of_bound`, else `value_of_learning`, else `proportion_of_reachable`,"
          + " else `score`";

  /** An aggregate of a policy over all scenarios. */
  record Statistic(PolicyScores policy, Aggregate aggregate, Estimate value) {}

  /** A point of a policy's performance profile. */
  record Point(PolicyScores policy, double tau, Estimate share) {}

  /** The probability that the first policy of a pair has a higher score than the second. */
  record Improvement(PolicyPair pair, Estimate probability) {}

  /**
   * The mean difference of a pair in one scenario; its p-value before and after correction.
   *
   * @param tests the number of p-values that are corrected together
   */
  record Difference(
      PolicyPair.InScenario pair, Estimate mean, double pValue, double corrected, int tests) {
    /** The number of seeds with which such a difference is found; infinity if it is 0. */
    double seedsNeeded() {
      return PairedTest.seedsNeeded(pair.differences(), tests);
    }
  }

  /** A table with a row per detection, policy and statistic. */
  public static final Table<Statistic> AGGREGATE =
      Table.<Statistic>of("aggregate.csv")
          .with(POLICY, Statistic::policy)
          .texts(
              "statistic",
              "`iqm`, `optimality_gap`, `mean` or `median`",
              row -> row.aggregate.label())
          .ints("scenarios", "", "number with a value", row -> row.policy.scores().scenarios())
          .ints("runs", "", "number with a value", row -> row.policy.scores().runs())
          .estimates("value", "", "share", "the statistic of `metric`", Statistic::value)
          .texts("metric", MEASURE, row -> row.policy.metric().label());

  /** A table with a row per detection, policy and tau. */
  public static final Table<Point> PROFILE =
      Table.<Point>of("profile.csv")
          .with(POLICY, Point::policy)
          .doubles("tau", "share", "0 to 1 in hundredths", Point::tau)
          .estimates(
              "share",
              "",
              "share",
              "runs whose proportion of the optimum (`metric` of `aggregate.csv`) is `tau` or"
                  + " more",
              Point::share);

  /** A table with a row per detection and pair of policies. */
  public static final Table<Improvement> IMPROVEMENT =
      Table.<Improvement>of("improvement.csv")
          .with(POLICY, row -> row.pair.first())
          .texts("other", OTHER, row -> row.pair.second().policy())
          .ints(
              "scenarios", "", "number with a value", row -> row.pair.first().scores().scenarios())
          .estimates(
              "probability",
              "",
              "probability",
              "a run of `policy` has a higher proportion than a run of `other` in the same scenario"
                  + " (a tie counts half; the mean over scenarios)",
              Improvement::probability);

  /** A table with a row per scenario, detection and pair of policies. */
  public static final Table<Difference> PAIRS =
      Table.<Difference>of("pairs.csv")
          .with(ComparisonFiles.CASE, row -> row.pair.first().plan())
          .texts("other", OTHER, row -> row.pair.second().plan().policy())
          .texts("metric", MEASURE, row -> row.pair.metric().label())
          .ints("runs", "", "seeds with a value", row -> row.pair.differences().length)
          .estimates(
              "difference", "", "share", "`policy` minus `other`, paired by seed", Difference::mean)
          .doubles(
              "p_value",
              "probability",
              "two-sided randomization test of the hypothesis that each difference could equally"
                  + " have the other sign; with up to 16 seeds over all choices of signs, with more"
                  + " over 99,999 drawn choices",
              Difference::pValue)
          .doubles(
              "p_holm",
              "probability",
              "`p_value` after Holm's correction over all rows of the file: with a limit of 0.05,"
                  + " the whole file has no false finding with a probability of 95 %",
              Difference::corrected)
          .doubles(
              "seeds_needed",
              "",
              "number with which a difference of this size and scatter is found among as many rows"
                  + " (`p_holm` below 0.05) in four of five studies; empty where the difference is"
                  + " 0 in all seeds",
              Difference::seedsNeeded);

  private AggregateFiles() {}

  /**
   * Adds the tables to a folder's files.
   *
   * @param cases every policy under every detection in every scenario
   * @param reference the policy that the others are compared with
   * @param threads the number of threads that share the work, 1 or more; each interval takes
   *     thousands of draws
   */
  public static void write(
      OutputFolder folder, List<CaseResult> cases, ReferencePolicy reference, int threads)
      throws IOException {
    List<PolicyScores> policies = PolicyScores.of(cases);
    List<PolicyPair> pairs = PolicyPair.of(policies, reference);
    if (Yardstick.of(cases).isPresent()) { // without one, scores are not shares
      List<List<Statistic>> statistics =
          Parallel.map(policies, threads, AggregateFiles::statistics);
      AGGREGATE.write(folder, statistics.stream().flatMap(List::stream));
      List<List<Point>> points = Parallel.map(policies, threads, AggregateFiles::points);
      PROFILE.write(folder, points.stream().flatMap(List::stream));
    }
    List<Improvement> improvements = Parallel.map(pairs, threads, AggregateFiles::improvement);
    IMPROVEMENT.write(folder, improvements.stream());
    PAIRS.write(folder, differences(pairs, threads));
  }

  private static List<Statistic> statistics(PolicyScores policy) {
    Map<Aggregate, Estimate> estimates = Aggregate.estimates(policy.scores());
    return Stream.of(Aggregate.values())
        .filter(estimates::containsKey)
        .map(aggregate -> new Statistic(policy, aggregate, estimates.get(aggregate)))
        .toList();
  }

  private static List<Point> points(PolicyScores policy) {
    Estimate[] shares = Aggregate.profile(policy.scores());
    return IntStream.range(0, shares.length)
        .mapToObj(i -> new Point(policy, Aggregate.TAUS[i], shares[i]))
        .toList();
  }

  private static Improvement improvement(PolicyPair pair) {
    return new Improvement(
        pair, Aggregate.improvement(pair.first().scores(), pair.second().scores()));
  }

  /**
   * Describes how many seeds it takes to find any difference; empty if there are enough.
   *
   * @param cases every policy under every detection in every scenario
   */
  public static Optional<String> tooFewSeeds(List<CaseResult> cases, ReferencePolicy reference) {
    int tests =
        (int)
            PolicyPair.of(PolicyScores.of(cases), reference).stream()
                .flatMap(pair -> pair.inScenarios().stream())
                .filter(pair -> pair.differences().length > 1) // otherwise it has no p-value
                .count();
    int seeds = cases.get(0).runs().size();
    int least = PairedTest.leastSeeds(tests);
    return tests == 0 || seeds < 2 || seeds >= least
        ? Optional.empty()
        : Optional.of(
            Texts.format(
                "%d seeds cannot show any of %d differences (p after Holm's correction): take %d"
                    + " seeds%s",
                seeds, tests, least, reference.isAll() ? ", or compare with one policy" : ""));
  }

  /** All pairs in all scenarios; Holm's correction is over all of them. */
  private static Stream<Difference> differences(List<PolicyPair> pairs, int threads) {
    List<PolicyPair.InScenario> inScenarios =
        pairs.stream().flatMap(pair -> pair.inScenarios().stream()).toList();
    double[] pValues =
        Parallel.map(inScenarios, threads, pair -> PairedTest.p(pair.differences())).stream()
            .mapToDouble(Double::doubleValue)
            .toArray();
    double[] corrected = PairedTest.corrected(pValues);
    int tests = PairedTest.tests(pValues);
    return IntStream.range(0, pValues.length)
        .mapToObj(
            i -> {
              PolicyPair.InScenario pair = inScenarios.get(i);
              Estimate mean = Estimate.mean(pair.differences());
              return new Difference(pair, mean, pValues[i], corrected[i], tests);
            });
  }
}
