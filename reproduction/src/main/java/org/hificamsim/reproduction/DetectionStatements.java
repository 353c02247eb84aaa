package org.hificamsim.reproduction;

import static org.hificamsim.reproduction.ReproductionPlans.CAMSIM;
import static org.hificamsim.reproduction.ReproductionPlans.EPSILON_GREEDY;
import static org.hificamsim.reproduction.ReproductionPlans.HIFI;
import static org.hificamsim.reproduction.ReproductionPlans.SARSA;
import static org.hificamsim.reproduction.ReproductionPlans.ZOOM_OUT;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.reproduction.Statements.Margin;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.compare.Ratio;
import org.hificamsim.runs.statistics.Bootstrap;

/** The checks of the statements in chapter 8 about the two detection models. */
final class DetectionStatements {
  private final Cases cases;
  private final Table81 table;

  DetectionStatements(Cases cases) {
    this.cases = cases;
    this.table = new Table81(cases);
  }

  List<Margin> margins(String id) {
    return switch (id) {
      case "camsim-underestimates" -> underestimates();
      case "same-order" -> sameOrder();
      case "scenario-3-least" -> scenarioThreeLeast();
      case "cluster-most" -> clusterMost();
      default -> throw new IllegalArgumentException("statement '" + id + "' has no checks");
    };
  }

  private List<Margin> underestimates() {
    List<Margin> cells = new ArrayList<>();
    for (Layout layout : Layout.values()) {
      for (String policy : PublishedCell.POLICIES) {
        cells.add(
            new Margin(
                layout.label() + ", " + policy,
                hifi(layout.scenarios(), policy).minus(camsim(layout.scenarios(), policy))));
      }
    }
    return cells;
  }

  /** The margins of pairs of policies, which both models have to put in the same order. */
  private List<Margin> sameOrder() {
    List<Margin> pairs = new ArrayList<>();
    for (String scenario : Layout.SCENARIOS) {
      pairs.add(pair(scenario, EPSILON_GREEDY, SARSA));
      pairs.add(pair(scenario, EPSILON_GREEDY, ZOOM_OUT));
      pairs.add(pair(scenario, SARSA, ZOOM_OUT));
    }
    return pairs;
  }

  private Margin pair(String scenario, String first, String second) {
    boolean firstIsBetter = difference(scenario, HIFI, first, second).value().mean() >= 0;
    return firstIsBetter
        ? difference(scenario, CAMSIM, first, second)
        : difference(scenario, CAMSIM, second, first);
  }

  private Margin difference(String scenario, String detection, String better, String worse) {
    return new Margin(
        scenario + ", " + better + " and " + worse,
        Estimate.difference(
            cases.find(scenario, detection, better).figures(Metric.PERFORMANCE),
            cases.find(scenario, detection, worse).figures(Metric.PERFORMANCE)));
  }

  private List<Margin> scenarioThreeLeast() {
    String third = Layout.CLUSTER.random();
    return Layout.SCENARIOS.stream()
        .filter(scenario -> !scenario.equals(third))
        .map(
            scenario ->
                gapDifference(scenario, List.of(scenario), List.of(third), PublishedCell.POLICIES))
        .toList();
  }

  private List<Margin> clusterMost() {
    List<Margin> margins = new ArrayList<>();
    for (String policy : PublishedCell.POLICIES) {
      for (Layout layout : List.of(Layout.LATTICE, Layout.RING)) {
        margins.add(
            gapDifference(
                policy + ", " + layout.label(),
                Layout.CLUSTER.scenarios(),
                layout.scenarios(),
                List.of(policy)));
      }
    }
    return margins;
  }

  /** The gap between the models in some scenarios minus that in others. */
  private Margin gapDifference(
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
        Bootstrap.of(
            plus.get(0).performance().length,
            seeds -> (sum(plus, seeds) - sum(minus, seeds)) / policies.size()));
  }

  private static double sum(List<Ratio> ratios, int[] seeds) {
    return ratios.stream().mapToDouble(ratio -> ratio.ofSeeds(seeds)).sum();
  }

  private Ratio hifi(List<String> scenarios, String policy) {
    return table.ratio(scenarios, HIFI, policy);
  }

  private Ratio camsim(List<String> scenarios, String policy) {
    return table.ratio(scenarios, CAMSIM, policy);
  }
}
