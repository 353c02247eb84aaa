package org.hificamsim.reproduction;

import static org.hificamsim.reproduction.ReproductionPlans.CAMSIM;
import static org.hificamsim.reproduction.ReproductionPlans.CAMSIM_45;
import static org.hificamsim.reproduction.ReproductionPlans.EPSILON_GREEDY;
import static org.hificamsim.reproduction.ReproductionPlans.EXPLORE_ANY;
import static org.hificamsim.reproduction.ReproductionPlans.HIFI;
import static org.hificamsim.reproduction.ReproductionPlans.ONE_HOP;
import static org.hificamsim.reproduction.ReproductionPlans.OPTIMAL;
import static org.hificamsim.reproduction.ReproductionPlans.ORIGIN;
import static org.hificamsim.reproduction.ReproductionPlans.REWARD_LITERAL;
import static org.hificamsim.reproduction.ReproductionPlans.REWARD_SIGN;
import static org.hificamsim.reproduction.ReproductionPlans.SARSA;
import static org.hificamsim.reproduction.ReproductionPlans.STANDARD;
import static org.hificamsim.reproduction.ReproductionPlans.ZOOM_OUT;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.Texts;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.compare.Ratio;

/** Recomputes Table 8.1: each cell is a ratio of sums over the two scenarios of a layout. */
public final class Table81 {
  private final Cases cases;

  public Table81(Cases cases) {
    this.cases = cases;
  }

  /**
   * A cell compared with the published one.
   *
   * @param ours the policy's performance over that of the optimum under the same detection model
   * @param readings the proportion under each other reading; NaN if the reading does not change it
   */
  public record Cell(
      PublishedCell published, Estimate ours, Verdict verdict, Map<Reading, Double> readings) {
    /** The proportion under a reading; NaN if the reading does not change it. */
    public double proportion(Reading reading) {
      return readings.get(reading);
    }

    /** The proportion under a reading, or under our defaults if the reading does not change it. */
    double proportion(Optional<Reading> reading) {
      return reading.map(readings::get).filter(value -> !value.isNaN()).orElse(ours.mean());
    }

    /** Returns our proportion minus the published one. */
    public double difference() {
      return ours.mean() - published.proportion();
    }

    /** Whether the cell was fitted or held out: our defaults were fitted to the hi-fi column. */
    public FitRole role() {
      return published.hifi() ? FitRole.FITTED : FitRole.HELD_OUT;
    }

    JudgedClaim judged() {
      return new JudgedClaim(
          "cell",
          String.join(
              "/",
              published.layout().label(),
              published.policy(),
              published.hifi() ? "hifi" : "camsim"),
          "Table 8.1",
          "proportion of the optimum",
          published.proportion(),
          ours,
          1,
          verdict == Verdict.REPRODUCED ? 1 : 0,
          verdict,
          reason(),
          role());
    }

    private String reason() {
      String off = Texts.format("off by %+.2f", difference());
      if (verdict != Verdict.NOT_REPRODUCED) {
        return off;
      }
      return published.hifi()
          ? off + "; state, discount and reward of SARSA, and the targets, are not published"
          : off + camSimReason();
    }

    private String camSimReason() {
      String formula =
          published.policy().equals(ZOOM_OUT)
              ? "CamSim's formula, Eq 6.2, depends on the zoom alone and can give 0 or 1 here"
              : Texts.format("CamSim's formula, Eq 6.2, gives %.2f", proportion(Reading.EQ_62));
      return Texts.format(
          "; %s; its threshold is not published; camsim-range at 0.45 over the hi-fi"
              + " optimum is %.2f",
          formula, proportion(Reading.HIFI_OPTIMUM_AT_45));
    }
  }

  /** The eighteen cells, in the order of the publication. */
  public List<Cell> cells() {
    return PublishedCell.table().stream().map(this::cell).toList();
  }

  private Cell cell(PublishedCell published) {
    Estimate ours =
        ratio(published.layout().scenarios(), published.detection(), published.policy()).estimate();
    Map<Reading, Double> readings = new EnumMap<>(Reading.class);
    for (Reading reading : Reading.values()) {
      readings.put(reading, mean(published, reading));
    }
    return new Cell(published, ours, Verdict.of(ours, published.proportion()), readings);
  }

  /** A cell under another reading; NaN if the reading does not change it. */
  private double mean(PublishedCell cell, Reading reading) {
    List<String> scenarios = cell.layout().scenarios();
    return switch (reading) {
      case ONE_HOP_GREEDY -> ratioTo(scenarios, cell.detection(), cell.policy(), ONE_HOP);
      case HIFI_OPTIMUM -> overHiFi(cell, CAMSIM);
      case HIFI_OPTIMUM_AT_45 -> overHiFi(cell, CAMSIM_45);
      case EXPLORE_ANY -> withPolicyReplaced(cell, EPSILON_GREEDY, EXPLORE_ANY);
      case SCRIPT_AT_ORIGIN ->
          cell.layout() == Layout.CLUSTER
              ? mean(List.of(cell.layout().random(), ORIGIN), cell.detection(), cell.policy())
              : Double.NaN;
      case EQ_62 -> cell.hifi() ? Double.NaN : mean(scenarios, STANDARD, cell.policy());
      case SIGN_REWARD -> withPolicyReplaced(cell, SARSA, REWARD_SIGN);
      case LITERAL_REWARD -> withPolicyReplaced(cell, SARSA, REWARD_LITERAL);
    };
  }

  /** The ratio of a policy over some scenarios. */
  Ratio ratio(List<String> scenarios, String detection, String policy) {
    return Ratio.of(find(scenarios, detection, policy));
  }

  double mean(List<String> scenarios, String detection, String policy) {
    return ratio(scenarios, detection, policy).mean();
  }

  /** The ratio to another policy's performance, in place of the optimum's. */
  private double ratioTo(List<String> scenarios, String detection, String policy, String other) {
    return Ratio.overPerformance(
            find(scenarios, detection, policy), find(scenarios, detection, other))
        .mean();
  }

  /**
   * The proportion of a cell with another policy in place of its own, which must be {@code policy};
   * NaN for the cells of other policies.
   */
  private double withPolicyReplaced(PublishedCell cell, String policy, String other) {
    return cell.policy().equals(policy)
        ? mean(cell.layout().scenarios(), cell.detection(), other)
        : Double.NaN;
  }

  /**
   * The proportion of a CamSim cell under a detection, over the hi-fi optimum; NaN for hi-fi cells.
   */
  private double overHiFi(PublishedCell cell, String detection) {
    List<String> scenarios = cell.layout().scenarios();
    return cell.hifi()
        ? Double.NaN
        : Ratio.over(find(scenarios, detection, cell.policy()), find(scenarios, HIFI, OPTIMAL))
            .mean();
  }

  private List<CaseResult> find(List<String> scenarios, String detection, String policy) {
    return scenarios.stream().map(name -> cases.find(name, detection, policy)).toList();
  }
}
