package org.hificamsim.reproduction.sensitivity;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** Where the conclusion holds and where it flips, in words. */
final class Findings {
  private Findings() {}

  /** Markdown: a paragraph per parameter. */
  static String of(List<Sweep> sweeps, List<Gap> gaps) {
    StringBuilder text =
        new StringBuilder(
            """
# Does CamSim's model underestimate?

Chapter 8 says so. Here it holds where the hi-fi proportion of the optimum is above CamSim's with
its whole 95% interval, by layout and policy; it flips where it is below with its whole interval.

""");
    for (Sweep sweep : sweeps) {
      text.append(paragraph(sweep, gaps.stream().filter(gap -> gap.isOf(sweep)).toList()));
    }
    return text.toString();
  }

  private static String paragraph(Sweep sweep, List<Gap> gaps) {
    List<Gap> cells = gaps.stream().filter(gap -> !gap.layout().equals(Gap.ALL)).toList();
    return String.format(
        Locale.ROOT,
        "## %s: the %s%n%nIt holds in %d of %d places. Everywhere at: %s.%n%nFlips: %s.%n%nOpen:"
            + " %s.%n%n",
        sweep.parameter(),
        sweep.meaning(),
        count(cells, Gap.Finding.UNDERESTIMATES),
        cells.size(),
        everywhere(sweep, cells),
        places(cells, Gap.Finding.OVERESTIMATES),
        places(cells, Gap.Finding.OPEN));
  }

  private static long count(List<Gap> cells, Gap.Finding finding) {
    return cells.stream().filter(gap -> gap.finding() == finding).count();
  }

  private static String everywhere(Sweep sweep, List<Gap> cells) {
    String values =
        sweep.variants().stream()
            .filter(
                variant ->
                    cells.stream()
                        .filter(gap -> gap.isAt(variant))
                        .allMatch(gap -> gap.finding() == Gap.Finding.UNDERESTIMATES))
            .map(variant -> variant.value() + (variant.standard() ? " (default)" : ""))
            .collect(Collectors.joining(", "));
    return values.isEmpty() ? "no value" : values;
  }

  private static String places(List<Gap> cells, Gap.Finding finding) {
    String places =
        cells.stream()
            .filter(gap -> gap.finding() == finding)
            .map(Findings::place)
            .collect(Collectors.joining("; "));
    return places.isEmpty() ? "nowhere" : places;
  }

  private static String place(Gap gap) {
    String at = "%s, %s, %s".formatted(gap.variant().value(), gap.layout(), gap.policy());
    return Double.isNaN(gap.difference().mean())
        ? at + " (no optimum above 0)"
        : at + String.format(Locale.ROOT, " (%+.2f)", gap.difference().mean());
  }
}
