package org.hificamsim.reproduction.sensitivity;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.output.CsvTable;
import org.hificamsim.runs.output.Table;

/** The files of a sensitivity study: one table, the pictures, and the findings in words. */
public final class SensitivityFiles {
  private SensitivityFiles() {}

  /** Writes all files and returns the findings. */
  public static String write(OutputFolder folder, Sweeps sweeps, List<CaseResult> results)
      throws IOException {
    List<Sweep> all = sweeps.all();
    List<Gap> gaps = new Gaps(new Cases(results)).of(all);
    List<Fit> fits = Fit.of(all, gaps);
    table(folder, gaps);
    fits(folder, fits);
    new GapFigures(gaps).write(folder, all);
    String findings = Findings.of(all, gaps) + Findings.ofFits(fits);
    try (PrintWriter out = new PrintWriter(folder.open("sensitivity.md"))) {
      out.print(findings);
    }
    return findings;
  }

  private static void fits(OutputFolder folder, List<Fit> fits) throws IOException {
    try (CsvTable table = Table.FIT.create(folder)) {
      for (Fit fit : fits) {
        table.row(
            fit.sweep().parameter(),
            fit.variant().value(),
            fit.variant().standard() ? "true" : "false",
            fit.hifi(),
            fit.camsim());
      }
    }
  }

  private static void table(OutputFolder folder, List<Gap> gaps) throws IOException {
    try (CsvTable table = Table.SENSITIVITY.create(folder)) {
      for (Gap gap : gaps) {
        table.row(
            gap.sweep().parameter(),
            gap.variant().value(),
            gap.variant().standard() ? "true" : "false",
            gap.layout(),
            gap.policy(),
            gap.hifi().mean(),
            gap.camsim().mean(),
            gap.difference().mean(),
            gap.difference().low(),
            gap.difference().high(),
            gap.finding().label());
      }
    }
  }
}
