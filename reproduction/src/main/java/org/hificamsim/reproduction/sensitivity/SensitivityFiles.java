package org.hificamsim.reproduction.sensitivity;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.reproduction.sensitivity.Sweeps.ParameterSweep;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.output.Table;

/** Writes the files of a sensitivity study: tables, pictures, and the findings in words. */
public final class SensitivityFiles {
  private static final String PARAMETER =
      "`threshold-hifi`, `threshold-camsim`, `targets`, `gamma`, `epsilon`, `k`, `reward`, `size`"
          + " (q, m), `optics` (focal length of the narrowest level, m), `f`, `g`, `state`,"
          + " `formula` (CamSim's), `speed` (m a step), `radii` (the widest, m), `alpha`, `q0`,"
          + " `ties` or `greedy` (what all are divided by)";
  private static final String VALUE =
      "its value, all else at the default; text, since some have words";
  private static final String DEFAULT = "`true` or `false`: whether the value is the default";

  /** A row per parameter, value, layout and policy. */
  public static final Table<Gap> GAPS =
      Table.<Gap>of("sensitivity.csv")
          .texts("parameter", PARAMETER, gap -> gap.sweep().parameter())
          .texts("value", VALUE, gap -> gap.variant().value())
          .texts("default", DEFAULT, gap -> String.valueOf(gap.variant().isDefault()))
          .texts(
              "layout",
              "`lattice`, `ring`, `cluster`, or `all` for the mean of the three",
              Gap::layout)
          .texts("policy", "the policy without options", Gap::policy)
          .doubles(
              "proportion_hifi",
              "share",
              "of the own optimum, as in Table 8.1; empty where that is 0",
              gap -> gap.hifi().mean())
          .doubles("proportion_camsim", "share", "the same of CamSim", gap -> gap.camsim().mean())
          .estimates("difference", "", "share", "hi-fi minus CamSim", Gap::difference)
          .texts(
              "finding",
              "`underestimates` (whole interval above 0), `overestimates` (below), `open`",
              gap -> gap.finding().label());

  /** A row per value of each parameter that changes a cell of Table 8.1. */
  public static final Table<Fit> FITS =
      Table.<Fit>of("fit.csv")
          .texts("parameter", "as above", fit -> fit.sweep().parameter())
          .texts("value", VALUE, fit -> fit.variant().value())
          .texts("default", DEFAULT, fit -> String.valueOf(fit.variant().isDefault()))
          .doubles(
              "error_hifi",
              "share",
              "mean distance of the nine cells of the hi-fi model from the published ones, all else"
                  + " at the default; empty where an optimum is 0",
              Fit::hifi)
          .doubles("error_camsim", "share", "the same of CamSim's model", Fit::camsim);

  private SensitivityFiles() {}

  /** Writes all files and returns the findings. */
  public static String write(OutputFolder folder, Sweeps sweeps, List<CaseResult> results)
      throws IOException {
    List<ParameterSweep> parameterSweeps = sweeps.all();
    List<Gap> gaps = Gap.of(parameterSweeps, new Cases(results));
    List<Fit> fits = Fit.of(parameterSweeps, gaps);
    GAPS.write(folder, gaps.stream());
    FITS.write(folder, fits.stream());
    new GapFigures(gaps).write(folder, parameterSweeps);
    String findings = Findings.describe(parameterSweeps, gaps) + Findings.describeFits(fits);
    try (PrintWriter out = new PrintWriter(folder.open("sensitivity.md"))) {
      out.print(findings);
    }
    return findings;
  }
}
