package org.hificamsim.runs.compare;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.output.CsvTable;
import org.hificamsim.runs.output.Table;
import org.hificamsim.runs.statistics.Aggregate;
import org.hificamsim.runs.statistics.Holm;
import org.hificamsim.runs.statistics.Improvement;
import org.hificamsim.runs.statistics.PerformanceProfile;
import org.hificamsim.runs.statistics.SignFlips;

/** The tables over all scenarios of a comparison, and those of pairs of policies. */
public final class AggregateFiles {
  private final OutputFolder folder;
  private final int threads;

  private AggregateFiles(OutputFolder folder, int threads) {
    this.folder = folder;
    this.threads = threads;
  }

  /**
   * Adds the tables to a folder's.
   *
   * @param cases every policy under every detection in every scenario
   * @param threads that share the work, 1 or more
   */
  public static void write(OutputFolder folder, List<CaseResult> cases, int threads)
      throws IOException {
    List<PolicyScores> policies = PolicyScores.of(cases);
    AggregateFiles files = new AggregateFiles(folder, threads);
    files.aggregates(policies);
    files.profiles(policies);
    files.improvements(PolicyPair.of(policies));
    files.pairs(PolicyPair.of(policies));
  }

  private void aggregates(List<PolicyScores> policies) throws IOException {
    try (CsvTable table = Table.AGGREGATE.create(folder)) {
      for (PolicyScores one : policies) {
        List<Aggregate> aggregates = List.of(Aggregate.values());
        List<Estimate> estimates = all(aggregates, figure -> figure.estimate(one.scores()));
        for (int i = 0; i < estimates.size(); i++) {
          Estimate value = estimates.get(i);
          table.row(
              one.detection(),
              one.policy(),
              aggregates.get(i).label(),
              one.scores().scenarios(),
              one.scores().runs(),
              value.mean(),
              value.low(),
              value.high());
        }
      }
    }
  }

  /** Side by side: an interval takes thousands of draws, and all of them seconds. */
  private <T, R> List<R> all(List<T> of, Function<T, R> estimate) {
    return Parallel.map(of, threads, estimate);
  }

  private void profiles(List<PolicyScores> policies) throws IOException {
    try (CsvTable table = Table.PROFILE.create(folder)) {
      List<PerformanceProfile> profiles = all(policies, one -> PerformanceProfile.of(one.scores()));
      for (int policy = 0; policy < policies.size(); policy++) {
        PolicyScores one = policies.get(policy);
        Estimate[] shares = profiles.get(policy).shares();
        for (int i = 0; i < shares.length; i++) {
          table.row(
              one.detection(),
              one.policy(),
              PerformanceProfile.TAUS[i],
              shares[i].mean(),
              shares[i].low(),
              shares[i].high());
        }
      }
    }
  }

  private void improvements(List<PolicyPair> pairs) throws IOException {
    try (CsvTable table = Table.IMPROVEMENT.create(folder)) {
      List<Estimate> estimates =
          all(pairs, pair -> Improvement.estimate(pair.one().scores(), pair.other().scores()));
      for (int i = 0; i < pairs.size(); i++) {
        PolicyPair pair = pairs.get(i);
        Estimate value = estimates.get(i);
        table.row(
            pair.one().detection(),
            pair.one().policy(),
            pair.other().policy(),
            pair.one().scores().scenarios(),
            value.mean(),
            value.low(),
            value.high());
      }
    }
  }

  /** One row per scenario, detection and pair; Holm's correction is over all rows. */
  private void pairs(List<PolicyPair> pairs) throws IOException {
    List<PolicyPair.InScenario> inScenarios = new ArrayList<>();
    pairs.forEach(pair -> inScenarios.addAll(pair.inScenarios()));
    double[] p =
        all(inScenarios, pair -> SignFlips.p(pair.differences().values())).stream()
            .mapToDouble(Double::doubleValue)
            .toArray();
    double[] corrected = Holm.corrected(p);
    try (CsvTable table = Table.PAIRS.create(folder)) {
      for (int i = 0; i < inScenarios.size(); i++) {
        PolicyPair.InScenario pair = inScenarios.get(i);
        Estimate difference = pair.differences().mean();
        table.row(
            pair.one().plan().scenario().name(),
            pair.one().plan().detection().name(),
            pair.one().plan().policy(),
            pair.other().plan().policy(),
            PolicyPair.SCORE.label(),
            pair.differences().size(),
            difference.mean(),
            difference.low(),
            difference.high(),
            p[i],
            corrected[i]);
      }
    }
  }
}
