package org.hificamsim.reproduction;

import static org.hificamsim.reproduction.ReproductionPlans.HIFI;
import static org.hificamsim.reproduction.ReproductionPlans.OPTIMAL;
import static org.hificamsim.reproduction.ReproductionPlans.ZOOM_OUT;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.Texts;
import org.hificamsim.reproduction.Judgement.FitRole;
import org.hificamsim.reproduction.Judgement.Judged;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.compare.Ratio;

/** Table 8.1 computed again: ratios of sums over the two scenarios of a layout, cell by cell. */
public final class Table81 {
  private final Cases cases;

  public Table81(Cases cases) {
    this.cases = cases;
  }

  /**
   * A cell compared with the published one.
   *
   * @param ours performance over that of the same detection model's optimum
   * @param readings what it is when read otherwise; NaN where that changes nothing
   */
  public record Cell(
      PublishedCell published, Estimate ours, Verdict verdict, Map<Reading, Double> readings) {
    /** What it is under a reading. */
    public double of(Reading reading) {
      return readings.get(reading);
    }

    /** What it is under a reading, our defaults where that changes nothing. */
    double of(Optional<Reading> reading) {
      return reading.map(readings::get).filter(value -> !value.isNaN()).orElse(ours.mean());
    }

    /** Ours less the published. */
    public double difference() {
      return ours.mean() - published.proportion();
    }

    /** Whether the defaults were chosen for it: the hi-fi column is what they were fitted to. */
    public FitRole role() {
      return published.hifi() ? FitRole.FITTED : FitRole.HELD_OUT;
    }

    Judged judged() {
      return new Judged(
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
          : off + camSim();
    }

    private String camSim() {
      String formula =
          published.policy().equals(ZOOM_OUT)
              ? "CamSim's formula, Eq 6.2, depends on the zoom alone and can give 0 or 1 here"
              : Texts.format("CamSim's formula, Eq 6.2, gives %.2f", of(Reading.EQ_62));
      return Texts.format(
          "; %s; its threshold is not published; camsim-range at 0.45 over the hi-fi"
              + " optimum is %.2f",
          formula, of(Reading.HIFI_OPTIMUM_AT_45));
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
      readings.put(reading, reading.of(this, published));
    }
    return new Cell(published, ours, Verdict.of(ours, published.proportion()), readings);
  }

  /** The ratio of a policy over some scenarios. */
  Ratio ratio(List<String> scenarios, String detection, String policy) {
    return Ratio.of(find(scenarios, detection, policy));
  }

  double mean(List<String> scenarios, String detection, String policy) {
    return ratio(scenarios, detection, policy).mean();
  }

  /** The ratio to another policy's performance, in place of the optimum's. */
  double over(List<String> scenarios, String detection, String policy, String other) {
    return Ratio.overPerformance(
            find(scenarios, detection, policy), find(scenarios, detection, other))
        .mean();
  }

  /** A cell of one policy under another one; NaN for all others. */
  double instead(PublishedCell cell, String policy, String other) {
    return cell.policy().equals(policy)
        ? mean(cell.layout().scenarios(), cell.detection(), other)
        : Double.NaN;
  }

  /** CamSim's cell over the hi-fi optimum; NaN for hi-fi. */
  double overHiFi(PublishedCell cell, String detection) {
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
