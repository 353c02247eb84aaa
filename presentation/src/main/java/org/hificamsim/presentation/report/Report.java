package org.hificamsim.presentation.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.core.InputException;

/** Makes the page of a folder that a command has written. */
public final class Report {
  private Report() {}

  /**
   * The page.
   *
   * @param name of the folder
   * @throws InputException when the folder does not hold what a page is made of
   */
  public static String html(Path folder, String name) throws IOException {
    if (!Files.isDirectory(folder)) {
      throw InputException.of(
          "no folder '%s', expected one that 'hificamsim run --record' or 'hificamsim"
              + " compare' wrote",
          folder);
    }
    if (TradeoffReport.suits(folder)) {
      return TradeoffReport.of(folder, name).html();
    }
    Page page =
        ComparisonReport.suits(folder) ? ComparisonReport.of(folder, name) : RunReport.of(folder);
    return page.html();
  }
}
