package org.hificamsim.runs.compare;

import java.io.IOException;
import java.util.List;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.output.ResultFolder;

/**
 * A comparison from plans to files, safe to kill at any moment: finished runs are in the journal,
 * and result files appear all at once at the end.
 */
public final class ComparisonRun {
  private final Comparison comparison;
  private final Yardsticks yardsticks;
  private final boolean resume;
  private final Ending ending;

  /**
   * @param yardsticks what is run beside the plans that are asked for
   * @param resume whether runs that an earlier, killed comparison finished count
   * @param ending what is still to be done when the files are in their place; should it fail, the
   *     journal stays and {@code resume} has all runs
   */
  public ComparisonRun(
      Comparison comparison, Yardsticks yardsticks, boolean resume, Ending ending) {
    this.comparison = comparison;
    this.yardsticks = yardsticks;
    this.resume = resume;
    this.ending = ending;
  }

  /** Makes further files of those that are in their place, such as the page. */
  @FunctionalInterface
  public interface Ending {
    /** Writes them. */
    void write() throws IOException;
  }

  /** Adds further files, such as plots and a manifest, to those of the results. */
  @FunctionalInterface
  public interface Extras {
    /** Writes them. */
    void write(OutputFolder folder, List<CaseResult> cases) throws IOException;
  }

  /**
   * Runs all plans and writes the results.
   *
   * @return one result per plan, then those of the optima that had to be added
   */
  public List<CaseResult> execute(List<RunPlan> plans, OutputFolder folder, Extras extras)
      throws IOException {
    return executeWithoutTables(
        plans,
        folder,
        (files, all) -> {
          ComparisonFiles.write(files, all.subList(0, plans.size()), all);
          extras.write(files, all);
        });
  }

  /** Runs all plans and writes the extras alone. */
  public List<CaseResult> executeWithoutTables(
      List<RunPlan> plans, OutputFolder folder, Extras extras) throws IOException {
    try (Journal journal = Journal.open(folder, Journal.NAME, resume)) {
      List<CaseResult> results = comparison.run(yardsticks.with(plans), journal);
      List<CaseResult> all = results.subList(0, Yardsticks.withOptimum(plans).size());
      extras.write(folder, all);
      ResultFolder.commit(folder, List.of(ResultFolder.REPORT, ResultFolder.CRATE));
      ending.write();
      journal.finish();
      return all;
    }
  }
}
