package org.hificamsim.reproduction;

import static org.hificamsim.reproduction.ReproductionPlans.ANY;
import static org.hificamsim.reproduction.ReproductionPlans.CAMSIM;
import static org.hificamsim.reproduction.ReproductionPlans.CAMSIM_45;
import static org.hificamsim.reproduction.ReproductionPlans.EPSILON_GREEDY;
import static org.hificamsim.reproduction.ReproductionPlans.LITERAL;
import static org.hificamsim.reproduction.ReproductionPlans.ONE_HOP;
import static org.hificamsim.reproduction.ReproductionPlans.ORIGIN;
import static org.hificamsim.reproduction.ReproductionPlans.SARSA;
import static org.hificamsim.reproduction.ReproductionPlans.SIGN;
import static org.hificamsim.reproduction.ReproductionPlans.STANDARD;

import java.util.List;

/** Where the thesis can be read in another way than our default, and what the cells are then. */
@SuppressWarnings("ImmutableEnumChecker") // functions
public enum Reading {
  ONE_HOP_GREEDY(
      "over_one_hop",
      "over the best configuration within one zoom level of the present one (thesis 7.4.1,"
          + " \"reachable from the current zoom level\"), in place of the best of all",
      (table, cell) ->
          table.over(cell.layout().scenarios(), cell.detection(), cell.policy(), ONE_HOP)),
  HIFI_OPTIMUM(
      "over_hifi_optimum",
      "CamSim's performance over the hi-fi optimum; empty for hi-fi",
      (table, cell) -> table.overHiFi(cell, CAMSIM)),
  HIFI_OPTIMUM_AT_45(
      "over_hifi_optimum_at_0.45",
      "the same with CamSim's threshold at 0.45",
      (table, cell) -> table.overHiFi(cell, CAMSIM_45)),
  EXPLORE_ANY(
      "explore_any",
      "epsilon-greedy whose exploring may draw the best level too; empty for other policies",
      (table, cell) -> table.instead(cell, EPSILON_GREEDY, ANY)),
  SCRIPT_AT_ORIGIN(
      "cluster_script_at_origin",
      "the cluster with its script about the field's centre; empty for other layouts",
      (table, cell) ->
          cell.layout() == Layout.CLUSTER
              ? table.mean(List.of(cell.layout().random(), ORIGIN), cell.detection(), cell.policy())
              : Double.NaN),
  EQ_62(
      "eq_6.2",
      "CamSim's cells under Eq 6.2 as printed, over its own optimum; empty for hi-fi",
      (table, cell) ->
          cell.hifi()
              ? Double.NaN
              : table.mean(cell.layout().scenarios(), STANDARD, cell.policy())),
  SIGN_REWARD(
      "reward_sign",
      "SARSA rewarded with the sign of the change in count; empty for other policies",
      (table, cell) -> table.instead(cell, SARSA, SIGN)),
  LITERAL_REWARD(
      "reward_literal",
      "SARSA rewarded by Eq 7.5 as printed; empty for other policies",
      (table, cell) -> table.instead(cell, SARSA, LITERAL));

  /** What a cell is; NaN where the reading does not change it. */
  @FunctionalInterface
  private interface Figure {
    double of(Table81 table, PublishedCell cell);
  }

  private final String label;
  private final String meaning;
  private final Figure figure;

  Reading(String label, String meaning, Figure figure) {
    this.label = label;
    this.meaning = meaning;
    this.figure = figure;
  }

  /** The name in files. */
  public String label() {
    return label;
  }

  /** What it reads otherwise. */
  public String meaning() {
    return meaning;
  }

  double of(Table81 table, PublishedCell cell) {
    return figure.of(table, cell);
  }
}
