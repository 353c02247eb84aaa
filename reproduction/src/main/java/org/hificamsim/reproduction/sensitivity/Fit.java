package org.hificamsim.reproduction.sensitivity;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.reproduction.PublishedCell;
import org.hificamsim.reproduction.sensitivity.Sweeps.ParameterSweep;
import org.hificamsim.reproduction.sensitivity.Sweeps.ParameterSweep.Variant;

/**
 * How far a setting is from Table 8.1, all else at its default: the mean distance of its nine cells
 * of a detection model. Many settings that are equally near show that the table does not tell them
 * apart.
 *
 * @param hifi from the hi-fi column, which the defaults were fitted to; NaN where a cell has no
 *     optimum above 0
 * @param camsim from CamSim's column
 */
record Fit(ParameterSweep sweep, Variant variant, double hifi, double camsim) {
  /** Distances nearer than this to the default's are as good. */
  static final double AS_GOOD = 0.01;

  /** Every value of every sweep that changes a cell of the table. */
  static List<Fit> of(List<ParameterSweep> sweeps, List<Gap> gaps) {
    Map<String, Gap> defaults = new LinkedHashMap<>();
    gaps.stream()
        .filter(gap -> gap.variant().standard())
        .forEach(gap -> defaults.put(cell(gap), gap));
    List<Fit> fits = new ArrayList<>();
    for (ParameterSweep sweep : sweeps) {
      if (sweep.policies().stream().anyMatch(PublishedCell.POLICIES::contains)) {
        sweep.variants().forEach(variant -> fits.add(of(sweep, variant, gaps, defaults)));
      }
    }
    return fits;
  }

  /** Whether this is another setting than the default's, and not of CamSim's model alone. */
  boolean isOther(Fit standard) {
    return !variant.standard() && variant.camsim() == standard.variant.camsim();
  }

  /** Whether the hi-fi column is as near as under the defaults. */
  boolean asGoodAs(Fit standard) {
    return hifi <= standard.hifi + AS_GOOD;
  }

  /** Whether the hi-fi column is the same to the last digit. */
  boolean sameAs(Fit standard) {
    return hifi == standard.hifi;
  }

  private static Fit of(
      ParameterSweep sweep, Variant variant, List<Gap> gaps, Map<String, Gap> defaults) {
    Map<String, Gap> own = new LinkedHashMap<>(defaults);
    gaps.stream()
        .filter(gap -> gap.isOf(sweep) && gap.isAt(variant))
        .forEach(gap -> own.put(cell(gap), gap));
    return new Fit(sweep, variant, distance(own, true), distance(own, false));
  }

  private static double distance(Map<String, Gap> cells, boolean hifi) {
    return PublishedCell.table().stream()
        .filter(cell -> cell.hifi() == hifi)
        .mapToDouble(cell -> distance(cells.get(cell(cell)), cell))
        .average()
        .orElseThrow();
  }

  private static double distance(Gap gap, PublishedCell cell) {
    double ours = (cell.hifi() ? gap.hifi() : gap.camsim()).mean();
    return Math.abs(ours - cell.proportion());
  }

  private static String cell(Gap gap) {
    return gap.layout() + "/" + gap.policy();
  }

  private static String cell(PublishedCell cell) {
    return cell.layout().label() + "/" + cell.policy();
  }
}
