package org.hificamsim.reproduction;

import static org.hificamsim.reproduction.ReproductionPlans.ANY;
import static org.hificamsim.reproduction.ReproductionPlans.CAMSIM;
import static org.hificamsim.reproduction.ReproductionPlans.CAMSIM_45;
import static org.hificamsim.reproduction.ReproductionPlans.EPSILON_GREEDY;
import static org.hificamsim.reproduction.ReproductionPlans.HIFI;
import static org.hificamsim.reproduction.ReproductionPlans.OPTIMAL;
import static org.hificamsim.reproduction.ReproductionPlans.ORIGIN;
import static org.hificamsim.reproduction.ReproductionPlans.STANDARD;
import static org.hificamsim.reproduction.ReproductionPlans.ZOOM_OUT;

import java.util.List;
import java.util.Locale;
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
   * A cell compared with the published one, with other readings of it; NaN where one does not
   * apply.
   *
   * @param ours performance over that of the same detection model's optimum
   * @param overHifi CamSim's performance over the hi-fi optimum
   * @param at45 the same with CamSim's threshold at 0.45
   * @param exploreAny epsilon-greedy that explores among all levels, the best one included
   * @param origin the cluster with the script about the field's centre
   * @param standard CamSim's cells under Eq 6.2 as printed
   */
  public record Cell(
      PublishedCell published,
      Estimate ours,
      Verdict verdict,
      double overHifi,
      double at45,
      double exploreAny,
      double origin,
      double standard) {
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
      String off = String.format(Locale.ROOT, "off by %+.2f", difference());
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
              : String.format(Locale.ROOT, "CamSim's formula, Eq 6.2, gives %.2f", standard);
      return String.format(
          Locale.ROOT,
          "; %s; its threshold is not published; camsim-range at 0.45 over the hi-fi optimum is"
              + " %.2f",
          formula,
          at45);
    }
  }

  /** The eighteen cells, in the order of the publication. */
  public List<Cell> cells() {
    return PublishedCell.table().stream().map(this::cell).toList();
  }

  private Cell cell(PublishedCell published) {
    Layout layout = published.layout();
    String policy = published.policy();
    boolean greedy = policy.equals(EPSILON_GREEDY);
    boolean cluster = layout == Layout.CLUSTER;
    Estimate ours = ratio(layout.scenarios(), published.detection(), policy).estimate();
    return new Cell(
        published,
        ours,
        Verdict.of(ours, published.proportion()),
        published.hifi() ? Double.NaN : overHifi(published, CAMSIM),
        published.hifi() ? Double.NaN : overHifi(published, CAMSIM_45),
        greedy ? mean(layout.scenarios(), published.detection(), ANY) : Double.NaN,
        cluster
            ? mean(List.of(layout.random(), ORIGIN), published.detection(), policy)
            : Double.NaN,
        published.hifi() ? Double.NaN : mean(layout.scenarios(), STANDARD, policy));
  }

  /** The ratio of a policy over some scenarios. */
  Ratio ratio(List<String> scenarios, String detection, String policy) {
    return Ratio.of(find(scenarios, detection, policy));
  }

  private double mean(List<String> scenarios, String detection, String policy) {
    return ratio(scenarios, detection, policy).estimate().mean();
  }

  private double overHifi(PublishedCell cell, String detection) {
    List<String> scenarios = cell.layout().scenarios();
    return Ratio.over(find(scenarios, detection, cell.policy()), find(scenarios, HIFI, OPTIMAL))
        .estimate()
        .mean();
  }

  private List<CaseResult> find(List<String> scenarios, String detection, String policy) {
    return scenarios.stream().map(name -> cases.find(name, detection, policy)).toList();
  }
}
