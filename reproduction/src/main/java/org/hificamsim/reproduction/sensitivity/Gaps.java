package org.hificamsim.reproduction.sensitivity;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.reproduction.Layout;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.compare.Ratio;

/** Computes the gaps of all sweeps. */
final class Gaps {
  private final Cases cases;

  Gaps(Cases cases) {
    this.cases = cases;
  }

  /** Every gap: by sweep, value, layout (then all), policy. */
  List<Gap> of(List<ParameterSweep> sweeps) {
    List<Gap> gaps = new ArrayList<>();
    for (ParameterSweep sweep : sweeps) {
      for (Variant variant : sweep.variants()) {
        for (Layout layout : Layout.values()) {
          gaps.addAll(gaps(sweep, variant, layout.label(), List.of(layout)));
        }
        gaps.addAll(gaps(sweep, variant, Gap.ALL, List.of(Layout.values())));
      }
    }
    return gaps;
  }

  private List<Gap> gaps(ParameterSweep sweep, Variant variant, String name, List<Layout> layouts) {
    return sweep.policies().stream()
        .map(policy -> gap(sweep, variant, name, policy, layouts))
        .toList();
  }

  private Gap gap(
      ParameterSweep sweep, Variant variant, String name, String policy, List<Layout> layouts) {
    List<Ratio> hifi = ratios(variant, variant.hifi(), policy, layouts);
    List<Ratio> camsim = ratios(variant, variant.camsim(), policy, layouts);
    int seeds = hifi.get(0).performance().length;
    return new Gap(
        sweep,
        variant,
        name,
        policy,
        Ratio.estimate(seeds, drawn -> mean(hifi, drawn)),
        Ratio.estimate(seeds, drawn -> mean(camsim, drawn)),
        Ratio.estimate(seeds, drawn -> mean(hifi, drawn) - mean(camsim, drawn)));
  }

  private static double mean(List<Ratio> ratios, int[] seeds) {
    return ratios.stream().mapToDouble(ratio -> ratio.at(seeds)).average().orElseThrow();
  }

  private List<Ratio> ratios(
      Variant variant, Detection detection, String policy, List<Layout> layouts) {
    return layouts.stream().map(layout -> ratio(variant, detection, policy, layout)).toList();
  }

  private Ratio ratio(Variant variant, Detection detection, String policy, Layout layout) {
    return Ratio.of(
        layout.scenarios().stream()
            .map(
                name ->
                    cases.find(
                        variant.scenarios().get(name).name(),
                        detection.name(),
                        variant.policies().get(policy)))
            .toList());
  }
}
