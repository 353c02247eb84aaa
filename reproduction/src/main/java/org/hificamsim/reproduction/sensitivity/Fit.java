package org.hificamsim.reproduction.sensitivity;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.reproduction.PublishedCell;
import org.hificamsim.reproduction.sensitivity.Sweeps.ParameterSweep;
import org.hificamsim.reproduction.sensitivity.Sweeps.ParameterSweep.Variant;

/**
 * The fit of a setting to Table 8.1 with all others at their defaults: the mean distance of the
 * nine cells of a detection model. If many settings fit equally well, the table cannot tell them
 * apart.
 *
 * @param hifi the distance from the hi-fi column, to which the defaults were fitted; NaN if a cell
 *     has no optimum above 0
 * @param camsim the distance from CamSim's column
 */
record Fit(ParameterSweep sweep, Variant variant, double hifi, double camsim) {
  /** The difference of distances up to which a fit counts as good as the defaults. */
  static final double TOLERANCE = 0.01;

  /** The fits of all values of the sweeps that change a cell of the table. */
  static List<Fit> of(List<ParameterSweep> sweeps, List<Gap> gaps) {
    Map<String, Gap> defaults = new LinkedHashMap<>();
    gaps.stream()
        .filter(gap -> gap.variant().isDefault())
        .forEach(gap -> defaults.put(cell(gap), gap));
    List<Fit> fits = new ArrayList<>();
    for (ParameterSweep sweep : sweeps) {
      if (sweep.policies().stream().anyMatch(PublishedCell.POLICIES::contains)) {
        sweep.variants().forEach(variant -> fits.add(of(sweep, variant, gaps, defaults)));
      }
    }
    return fits;
  }

  /** Whether this is not a default, and not a setting of CamSim's model alone. */
  boolean isOther(Fit defaults) {
    return !variant.isDefault() && variant.camsim() == defaults.variant.camsim();
  }

  /** Whether the fit to the hi-fi column is as good as with the defaults. */
  boolean isAsGoodAs(Fit defaults) {
    return hifi <= defaults.hifi + TOLERANCE;
  }

  /** Whether the hi-fi column is the same to the last digit. */
  boolean isSameAs(Fit defaults) {
    return hifi == defaults.hifi;
  }

  private static Fit of(
      ParameterSweep sweep, Variant variant, List<Gap> gaps, Map<String, Gap> defaults) {
    Map<String, Gap> cells = new LinkedHashMap<>(defaults);
    gaps.stream()
        .filter(gap -> gap.isOf(sweep) && gap.isAt(variant))
        .forEach(gap -> cells.put(cell(gap), gap));
    return new Fit(sweep, variant, distance(cells, true), distance(cells, false));
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
