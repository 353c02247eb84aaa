package org.hificamsim.reproduction;

import java.util.List;
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
  }

  /** The eighteen cells, in the order of the publication. */
  public List<Cell> cells() {
    return PublishedCell.table().stream().map(this::cell).toList();
  }

  private Cell cell(PublishedCell published) {
    Estimate ours = ratio(published).estimate();
    return new Cell(
        published,
        ours,
        Verdict.of(ours, published.proportion()),
        overHifi(published, ReproductionPlans.CAMSIM),
        overHifi(published, ReproductionPlans.CAMSIM_45),
        exploreAny(published),
        origin(published),
        standard(published));
  }

  /** The ratio of a cell. */
  Ratio ratio(PublishedCell cell) {
    return ratio(cell.layout().scenarios(), cell.detection(), cell.policy());
  }

  /** The ratio of a policy over some scenarios. */
  Ratio ratio(List<String> scenarios, String detection, String policy) {
    return Ratio.of(find(scenarios, detection, policy));
  }

  private double overHifi(PublishedCell cell, String detection) {
    if (cell.hifi()) {
      return Double.NaN;
    }
    List<String> scenarios = cell.layout().scenarios();
    return Ratio.over(
            find(scenarios, detection, cell.policy()),
            find(scenarios, ReproductionPlans.HIFI, ReproductionPlans.OPTIMAL))
        .estimate()
        .mean();
  }

  private double exploreAny(PublishedCell cell) {
    return cell.policy().equals(ReproductionPlans.EPSILON_GREEDY)
        ? ratio(cell.layout().scenarios(), cell.detection(), ReproductionPlans.ANY)
            .estimate()
            .mean()
        : Double.NaN;
  }

  private double origin(PublishedCell cell) {
    return cell.layout() == Layout.CLUSTER
        ? ratio(
                List.of(cell.layout().random(), ReproductionPlans.ORIGIN),
                cell.detection(),
                cell.policy())
            .estimate()
            .mean()
        : Double.NaN;
  }

  private double standard(PublishedCell cell) {
    return cell.hifi()
        ? Double.NaN
        : ratio(cell.layout().scenarios(), ReproductionPlans.STANDARD, cell.policy())
            .estimate()
            .mean();
  }

  private List<CaseResult> find(List<String> scenarios, String detection, String policy) {
    return scenarios.stream().map(name -> cases.find(name, detection, policy)).toList();
  }
}
