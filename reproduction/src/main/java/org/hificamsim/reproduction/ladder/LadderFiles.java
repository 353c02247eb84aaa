package org.hificamsim.reproduction.ladder;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.reproduction.ladder.Ladder.RungScenario;
import org.hificamsim.reproduction.ladder.LadderResult.RungResult;
import org.hificamsim.reproduction.ladder.Rungs.Rung;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.compare.RungScores;
import org.hificamsim.runs.output.JsonOutput;
import org.hificamsim.runs.output.Table;

/** Writes the files of a ladder: two tables, pictures, and the cost of a step on this machine. */
public final class LadderFiles {
  /** The separator of policies that tie; no name or option of a policy contains it. */
  public static final String OR = " | ";

  private static final String COST = "cost";

  /** The prediction of a rung for a policy in a scenario. */
  record PolicyRow(RungScenario variant, String policy, Estimate score, int rank) {}

  /** A row per scenario, rung and policy. */
  public static final Table<PolicyRow> POLICIES =
      Table.<PolicyRow>of("ladder.csv")
          .texts(
              "scenario",
              "as it was given, also where a rung changes it",
              row -> row.variant.scenario())
          .texts(
              "rung",
              "its name: that of its detection, unless it changes the scenario",
              row -> row.variant.rung().name())
          .texts("policy", "the zoom policy with its options", PolicyRow::policy)
          .estimates(
              "mean_k_min", "", "cameras", "the score that the rung predicts", PolicyRow::score)
          .ints(
              "rank",
              "",
              "1 for the best; policies that tie share the better place",
              PolicyRow::rank);

  /** A row per scenario and rung, then one per rung for all scenarios. */
  public static final Table<RungResult> RUNGS =
      Table.<RungResult>of("rungs.csv")
          .texts("scenario", "its name; `all` for the mean", RungResult::scenario)
          .texts("rung", "its name", row -> row.rung().name())
          .doubles(
              "optimum",
              "cameras",
              "mean `k_min` of the exact optimum under the rung; by chance it knows the luck",
              row -> row.optimum().mean())
          .estimates(
              "tau",
              "tau_",
              "-1 to 1",
              "Kendall's tau-b between the order of the policies under the rung and under the top"
                  + " one, the last; empty where all tie",
              RungResult::tau)
          .texts(
              "chosen",
              "the policy with the best score under the rung; several, with a bar between, where"
                  + " they tie; empty for `all`",
              row -> String.join(OR, row.chosen()))
          .estimates(
              "regret",
              "regret_",
              "cameras",
              "under the top rung, the best policy's score less that of the policy chosen, paired"
                  + " by seed; the mean over those that tie",
              RungResult::regret)
          .estimates(
              "share",
              "share_",
              "share",
              "the same as a share of that best score; empty where it is 0",
              RungResult::share);

  private final OutputFolder folder;
  private final Ladder ladder;
  private final Cases cases;

  private LadderFiles(OutputFolder folder, Ladder ladder, List<CaseResult> results) {
    this.folder = folder;
    this.ladder = ladder;
    this.cases = new Cases(results);
  }

  /** Measures the costs and writes all files. */
  public static LadderResult write(
      OutputFolder folder, Ladder ladder, List<CaseResult> results, Catalogue catalogue)
      throws IOException {
    StepCost cost = new StepCost(new RunExecutor(catalogue), ladder.policies().get(0));
    return new LadderFiles(folder, ladder, results).write(cost.measure(ladder.all()));
  }

  private LadderResult write(List<Double> costs) throws IOException {
    LadderResult result = LadderResult.of(ladder, cases, byRung(costs));
    POLICIES.write(folder, ladder.all().stream().flatMap(this::policies));
    RUNGS.write(folder, result.rungs().stream());
    writeCosts(costs);
    LadderFigures figures = new LadderFigures(result);
    FigureFile.write(folder, "ladder", figures.byScenario());
    FigureFile.write(folder, COST, figures.overview());
    return result;
  }

  /** The mean costs over the scenarios, by rung. */
  private List<Double> byRung(List<Double> costs) {
    Map<Rung, Double> means =
        IntStream.range(0, costs.size())
            .boxed()
            .collect(
                Collectors.groupingBy(
                    i -> ladder.all().get(i).rung(), Collectors.averagingDouble(costs::get)));
    return ladder.rungs().stream().map(means::get).toList();
  }

  private Stream<PolicyRow> policies(RungScenario variant) {
    RungScores scores = RungScores.of(variant.results(cases, ladder.policies()));
    int[] ranks = scores.ranks();
    return IntStream.range(0, ranks.length)
        .mapToObj(
            policy ->
                new PolicyRow(
                    variant,
                    ladder.policies().get(policy),
                    Metric.MEAN_SCORE.mean(
                        variant.plan(ladder.policies().get(policy), Settings.NONE),
                        scores.score()[policy]),
                    ranks[policy]));
  }

  private void writeCosts(List<Double> costs) throws IOException {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("policy", ladder.policies().get(0));
    json.put("threads", 1);
    ArrayNode steps = json.putArray("steps");
    for (int i = 0; i < costs.size(); i++) {
      RungScenario variant = ladder.all().get(i);
      ObjectNode step = steps.addObject();
      step.put("scenario", variant.scenario());
      step.put("rung", variant.rung().name());
      step.put("nanoseconds", costs.get(i));
    }
    JsonOutput.write(folder, COST + ".json", json);
  }

  /**
   * Measures the time of a step on this machine, with all metrics of a run: the least of several
   * timed runs in one thread, which are so short that other programs rarely interrupt them.
   */
  static final class StepCost {
    private static final long MIN_NANOSECONDS = 2_000_000;
    private static final int ROUNDS = 25;
    private static final int FIRST_STEPS = 16;
    private static final int MAX_STEPS = 1 << 24;

    private final RunExecutor executor;
    private final String policy;

    StepCost(RunExecutor executor, String policy) {
      this.executor = executor;
      this.policy = policy;
    }

    /** Measures the nanoseconds of a step of each variant, in turns, under the same load. */
    List<Double> measure(List<RungScenario> variants) {
      List<RunPlan> plans = variants.stream().map(this::calibrated).toList();
      double[] least = plans.stream().mapToDouble(this::nanoseconds).toArray();
      for (int round = 1; round < ROUNDS; round++) {
        for (int i = 0; i < least.length; i++) {
          least[i] = Math.min(least[i], nanoseconds(plans.get(i)));
        }
      }
      return Arrays.stream(least).boxed().toList();
    }

    /** A plan with enough steps for the clock; its code is compiled by then. */
    private RunPlan calibrated(RungScenario variant) {
      RunPlan plan = plan(variant, FIRST_STEPS);
      while (isShort(plan) && plan.steps() < MAX_STEPS) {
        plan = plan(variant, 2 * plan.steps());
      }
      return plan;
    }

    private RunPlan plan(RungScenario variant, int steps) {
      return variant.plan(policy, Settings.NONE.with(Setting.STEPS, Integer.toString(steps)));
    }

    /** Whether any of three runs is too short; a longer one may have been interrupted. */
    private boolean isShort(RunPlan plan) {
      return IntStream.range(0, 3)
          .anyMatch(attempt -> nanoseconds(plan) * plan.steps() < MIN_NANOSECONDS);
    }

    private double nanoseconds(RunPlan plan) {
      long start = System.nanoTime();
      executor.repeat(plan, 0, List.of());
      return (double) (System.nanoTime() - start) / plan.steps();
    }
  }
}
