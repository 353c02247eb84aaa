package org.hificamsim.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.hificamsim.presentation.figures.FigureStyle;
import org.hificamsim.presentation.plot.PrintWidth;
import org.hificamsim.runs.RunPlan;
import picocli.CommandLine.Option;

/** The options of pictures: their width in print, and the colours and words of policies. */
final class FigureOptions {
  @Option(names = "--figure-width", paramLabel = "MMmm")
  private Optional<String> width;

  @Option(names = "--style", paramLabel = "FILE.json")
  private Optional<Path> style;

  @Option(names = "--palette", paramLabel = "NAME|#C,#D")
  private String palette;

  @Option(names = "--label", paramLabel = "NAME=TEXT")
  private List<String> labels = List.of();

  /** The width in print; empty for the size on screens. */
  Optional<PrintWidth> width() {
    return width.map(PrintWidth::parse);
  }

  /**
   * Returns the style of the pictures of some plans.
   *
   * @throws org.hificamsim.core.InputException if an option names no policy or detection of the
   *     plans, or the file of the style is malformed
   */
  FigureStyle style(List<RunPlan> plans) {
    Set<String> names = new TreeSet<>();
    for (RunPlan plan : plans) {
      names.add(plan.policy());
      names.add(plan.detection().name());
    }
    return style.map(FigureStyle::read).orElse(FigureStyle.DEFAULT).with(palette, labels, names);
  }
}
