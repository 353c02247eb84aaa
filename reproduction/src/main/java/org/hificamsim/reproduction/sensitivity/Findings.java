package org.hificamsim.reproduction.sensitivity;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.hificamsim.core.Texts;
import org.hificamsim.reproduction.sensitivity.Sweeps.ParameterSweep;

/** Writes in words for which values the conclusion holds and for which it flips. */
final class Findings {
  private Findings() {}

  /** A paragraph in Markdown for each parameter. */
  static String describe(List<ParameterSweep> sweeps, List<Gap> gaps) {
    StringBuilder text =
        new StringBuilder(
            """
# Does CamSim's model underestimate?

Chapter 8 says so. Here it holds where the hi-fi proportion of the optimum is above CamSim's with
its whole 95% interval, by layout and policy; it flips where it is below with its whole interval.

""");
    for (ParameterSweep sweep : sweeps) {
      text.append(paragraph(sweep, gaps.stream().filter(gap -> gap.isOf(sweep)).toList()));
    }
    return text.toString();
  }

  /** A paragraph in Markdown on the settings that fit the hi-fi column as well as the defaults. */
  static String describeFits(List<Fit> fits) {
    Fit defaults = fits.stream().filter(fit -> fit.variant().isDefault()).findFirst().orElseThrow();
    List<Fit> others = fits.stream().filter(fit -> fit.isOther(defaults)).toList();
    return String.format(
        Locale.ROOT,
        """
## How many settings fit Table 8.1 as well

The defaults were fitted to the hi-fi column: their mean distance from its nine cells is %.3f here. Of the %d other
settings that bear on it, each with all else at its default, %d come as near (within %.2f), %d of these with the same
results to the last digit: %s. `fit.csv` has all of them.

""",
        defaults.hifi(),
        others.size(),
        others.stream().filter(fit -> fit.isAsGoodAs(defaults)).count(),
        Fit.TOLERANCE,
        others.stream().filter(fit -> fit.isSameAs(defaults)).count(),
        asGood(others, defaults));
  }

  private static String asGood(List<Fit> others, Fit defaults) {
    String names =
        others.stream()
            .filter(fit -> fit.isAsGoodAs(defaults))
            .map(Findings::name)
            .collect(Collectors.joining(", "));
    return names.isEmpty() ? "none" : names;
  }

  private static String name(Fit fit) {
    return Texts.format("%s %s (%.3f)", fit.sweep().parameter(), fit.variant().value(), fit.hifi());
  }

  private static String paragraph(ParameterSweep sweep, List<Gap> gaps) {
    List<Gap> cells = gaps.stream().filter(gap -> !gap.layout().equals(Gap.ALL)).toList();
    return Texts.format(
        "## %s: the %s%n%nIt holds in %d of %d places. Everywhere at: %s.%n%nFlips:"
            + " %s.%n%nOpen: %s.%n%n",
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

  private static String everywhere(ParameterSweep sweep, List<Gap> cells) {
    String values =
        sweep.variants().stream()
            .filter(
                variant ->
                    cells.stream()
                        .filter(gap -> gap.isAt(variant))
                        .allMatch(gap -> gap.finding() == Gap.Finding.UNDERESTIMATES))
            .map(variant -> variant.value() + (variant.isDefault() ? " (default)" : ""))
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
        : at + Texts.format(" (%+.2f)", gap.difference().mean());
  }
}
