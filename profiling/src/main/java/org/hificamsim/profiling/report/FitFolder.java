package org.hificamsim.profiling.report;

import java.io.IOException;
import java.nio.file.Path;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.FittedModel;
import org.hificamsim.profiling.measure.PipReading;

/** Everything that a fit leaves in the folder of its data set. */
public final class FitFolder {
  /** The page. */
  public static final String REPORT = "report.html";

  private FitFolder() {}

  /**
   * Writes all files or none; a model that is refused loses the file of an earlier fit.
   *
   * @param title of the report
   * @param prefix of the models' names, before a colon
   * @return how many models were written
   */
  public static int write(
      Path folder, FitResult result, PipReading pip, String title, String prefix)
      throws IOException {
    try (OutputFolder files = new OutputFolder(folder)) {
      int models = FittedModel.writeAll(result, files, prefix);
      FitReport.write(result, pip, title, files);
      files.commit(FittedModel.all(result).stream().map(FittedModel::file).toList());
      return models;
    }
  }
}
