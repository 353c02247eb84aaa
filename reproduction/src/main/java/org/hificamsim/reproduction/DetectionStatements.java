package org.hificamsim.reproduction;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.reproduction.Statement.Margin;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.compare.Ratio;

/** What chapter 8 says of the two detection models. */
public final class DetectionStatements {
  private final Table81 table;
  private final Margins margins;

  public DetectionStatements(Cases cases) {
    table = new Table81(cases);
    margins = new Margins(cases);
  }

  /** All statements, in the order of the text. */
  public List<Statement> all() {
    return List.of(underestimates(), sameOrder(), scenarioThree(), cluster());
  }

  private Statement underestimates() {
    List<Margin> cells = new ArrayList<>();
    for (Layout layout : Layout.values()) {
      for (String policy : PublishedCell.POLICIES) {
        cells.add(
            new Margin(
                layout.label() + ", " + policy,
                hifi(layout.scenarios(), policy).minus(camsim(layout.scenarios(), policy))));
      }
    }
    return new Statement(
        "camsim-underestimates",
        "8.1, Table 8.1",
        "Under CamSim's model every policy reaches less of the optimum, in all nine cells.",
        cells,
        "");
  }

  /** For each pair of policies, their order under CamSim's model is that under the hi-fi one. */
  private Statement sameOrder() {
    List<Margin> pairs = new ArrayList<>();
    for (String scenario : Layout.SCENARIOS) {
      pairs.add(pair(scenario, ReproductionPlans.EPSILON_GREEDY, ReproductionPlans.SARSA));
      pairs.add(pair(scenario, ReproductionPlans.EPSILON_GREEDY, ReproductionPlans.ZOOM_OUT));
      pairs.add(pair(scenario, ReproductionPlans.SARSA, ReproductionPlans.ZOOM_OUT));
    }
    return new Statement(
        "same-order",
        "8.1, Figure 8.1",
        "The results under both models are alike qualitatively.",
        pairs,
        "read as: policies stand in the same order under both, in all scenarios");
  }

  private Margin pair(String scenario, String one, String other) {
    Metric metric = Metric.PERFORMANCE;
    Margin hifi =
        Margins.more("", margins.hifi(scenario, one), margins.hifi(scenario, other), metric);
    boolean up = hifi.value().mean() >= 0;
    String better = up ? one : other;
    String worse = up ? other : one;
    return Margins.more(
        scenario + ", " + better + " and " + worse,
        margins.camsim(scenario, better),
        margins.camsim(scenario, worse),
        metric);
  }

  private Statement scenarioThree() {
    String third = Layout.CLUSTER.random();
    List<Margin> others = new ArrayList<>();
    for (String scenario : Layout.SCENARIOS) {
      if (!scenario.equals(third)) {
        others.add(lessGap(scenario, List.of(scenario), List.of(third), PublishedCell.POLICIES));
      }
    }
    return new Statement(
        "scenario-3-least",
        "8.1",
        "The underestimation is minimal in scenario 3.",
        others,
        "mean over the three policies, against each other scenario");
  }

  private Statement cluster() {
    List<Margin> others = new ArrayList<>();
    for (String policy : PublishedCell.POLICIES) {
      for (Layout layout : List.of(Layout.LATTICE, Layout.RING)) {
        others.add(
            lessGap(
                policy + ", " + layout.label(),
                Layout.CLUSTER.scenarios(),
                layout.scenarios(),
                List.of(policy)));
      }
    }
    return new Statement(
        "cluster-most",
        "8.1",
        "The cluster layout is the most affected by the underestimation.",
        others,
        "each policy's gap, against lattice and ring; in the published table lattice has the"
            + " widest for epsilon-greedy and SARSA");
  }

  /** How much wider the gap between the models is in some scenarios than in others. */
  private Margin lessGap(
      String where, List<String> wide, List<String> narrow, List<String> policies) {
    List<Ratio> plus = new ArrayList<>();
    List<Ratio> minus = new ArrayList<>();
    for (String policy : policies) {
      plus.add(hifi(wide, policy));
      plus.add(camsim(narrow, policy));
      minus.add(camsim(wide, policy));
      minus.add(hifi(narrow, policy));
    }
    return new Margin(
        where,
        Ratio.estimate(
            plus.get(0).performance().length,
            seeds -> (sum(plus, seeds) - sum(minus, seeds)) / policies.size()));
  }

  private static double sum(List<Ratio> ratios, int[] seeds) {
    return ratios.stream().mapToDouble(ratio -> ratio.at(seeds)).sum();
  }

  private Ratio hifi(List<String> scenarios, String policy) {
    return table.ratio(scenarios, ReproductionPlans.HIFI, policy);
  }

  private Ratio camsim(List<String> scenarios, String policy) {
    return table.ratio(scenarios, ReproductionPlans.CAMSIM, policy);
  }
}
