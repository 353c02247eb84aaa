package org.hificamsim.reproduction.sensitivity;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.reproduction.Layout;
import org.hificamsim.reproduction.sensitivity.Sweeps.ParameterSweep;
import org.hificamsim.reproduction.sensitivity.Sweeps.ParameterSweep.Variant;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.compare.Ratio;
import org.hificamsim.runs.statistics.Bootstrap;

/**
 * The gap between the detection models, on which the conclusion of chapter 8 rests: the hi-fi
 * proportion of the optimum minus CamSim's, for a value of a parameter, a layout and a policy.
 *
 * @param layout a layout, or {@code all} for the mean over the three
 * @param hifi the hi-fi proportion; NaN if its optimum is always 0
 * @param camsim CamSim's proportion; NaN if its optimum is always 0
 * @param difference the first minus the second
 */
record Gap(
    ParameterSweep sweep,
    Variant variant,
    String layout,
    String policy,
    Estimate hifi,
    Estimate camsim,
    Estimate difference) {
  /** All layouts together. */
  static final String ALL = "all";

  /** The meaning of a gap for the conclusion. */
  enum Finding {
    UNDERESTIMATES,
    OVERESTIMATES,
    OPEN;

    /** The name in files. */
    String label() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  boolean isOf(ParameterSweep other) {
    return sweep.parameter().equals(other.parameter());
  }

  boolean isAt(Variant other) {
    return variant.value().equals(other.value());
  }

  /** The index of the value in its sweep. */
  int index() {
    return sweep.variants().stream().map(Variant::value).toList().indexOf(variant.value());
  }

  /** The finding; it is open if the 95% interval contains 0. */
  Finding finding() {
    if (difference.low() > 0) {
      return Finding.UNDERESTIMATES;
    }
    return difference.high() < 0 ? Finding.OVERESTIMATES : Finding.OPEN;
  }

  /** All gaps, in the order of sweeps, values, layouts (then all layouts together) and policies. */
  static List<Gap> of(List<ParameterSweep> sweeps, Cases cases) {
    List<Gap> gaps = new ArrayList<>();
    for (ParameterSweep sweep : sweeps) {
      for (Variant variant : sweep.variants()) {
        for (Layout layout : Layout.values()) {
          gaps.addAll(of(sweep, variant, layout.label(), List.of(layout), cases));
        }
        gaps.addAll(of(sweep, variant, ALL, List.of(Layout.values()), cases));
      }
    }
    return gaps;
  }

  private static List<Gap> of(
      ParameterSweep sweep, Variant variant, String name, List<Layout> layouts, Cases cases) {
    List<Gap> gaps = new ArrayList<>();
    for (String policy : sweep.policies()) {
      List<Ratio> hifi = ratios(variant, variant.hifi(), policy, layouts, cases);
      List<Ratio> camsim = ratios(variant, variant.camsim(), policy, layouts, cases);
      int seeds = hifi.get(0).performance().length;
      gaps.add(
          new Gap(
              sweep,
              variant,
              name,
              policy,
              Bootstrap.of(seeds, drawn -> mean(hifi, drawn)),
              Bootstrap.of(seeds, drawn -> mean(camsim, drawn)),
              Bootstrap.of(seeds, drawn -> mean(hifi, drawn) - mean(camsim, drawn))));
    }
    return gaps;
  }

  private static double mean(List<Ratio> ratios, int[] seeds) {
    return ratios.stream().mapToDouble(ratio -> ratio.ofSeeds(seeds)).average().orElseThrow();
  }

  private static List<Ratio> ratios(
      Variant variant, Detection detection, String policy, List<Layout> layouts, Cases cases) {
    return layouts.stream()
        .map(
            layout ->
                Ratio.overPerformance(
                    results(variant, detection, variant.policies().get(policy), layout, cases),
                    results(variant, detection, variant.greedy(), layout, cases)))
        .toList();
  }

  private static List<CaseResult> results(
      Variant variant, Detection detection, String policy, Layout layout, Cases cases) {
    return layout.scenarios().stream()
        .map(name -> variant.scenarios().get(name).name())
        .map(name -> cases.find(name, detection.name(), policy))
        .toList();
  }
}
