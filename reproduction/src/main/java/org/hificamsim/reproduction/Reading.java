package org.hificamsim.reproduction;

/** Readings of open points of the thesis that differ from our defaults. */
public enum Reading {
  ONE_HOP_GREEDY(
      "over_one_hop",
      "over the best configuration within one zoom level of the present one (thesis 7.4.1,"
          + " \"reachable from the current zoom level\"), in place of the best of all"),
  HIFI_OPTIMUM("over_hifi_optimum", "CamSim's performance over the hi-fi optimum; empty for hi-fi"),
  HIFI_OPTIMUM_AT_45("over_hifi_optimum_at_0.45", "the same with CamSim's threshold at 0.45"),
  EXPLORE_ANY(
      "explore_any",
      "epsilon-greedy whose exploring may draw the best level too; empty for other policies"),
  SCRIPT_AT_ORIGIN(
      "cluster_script_at_origin",
      "the cluster with its script about the field's centre; empty for other layouts"),
  EQ_62("eq_6.2", "CamSim's cells under Eq 6.2 as printed, over its own optimum; empty for hi-fi"),
  SIGN_REWARD(
      "reward_sign",
      "SARSA rewarded with the sign of the change in count; empty for other policies"),
  LITERAL_REWARD("reward_literal", "SARSA rewarded by Eq 7.5 as printed; empty for other policies");

  private final String label;
  private final String meaning;

  Reading(String label, String meaning) {
    this.label = label;
    this.meaning = meaning;
  }

  /** The name in files. */
  public String label() {
    return label;
  }

  /** The difference from our defaults. */
  public String meaning() {
    return meaning;
  }
}
