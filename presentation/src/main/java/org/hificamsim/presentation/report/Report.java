package org.hificamsim.presentation.report;

import static org.hificamsim.core.NamedSetting.setting;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.core.InputException;
import org.hificamsim.core.NamedSetting;

/** Makes the page of a folder that a command wrote. */
public final class Report {
  private Report() {}

  /**
   * Returns the page as HTML.
   *
   * @param name the name of the folder
   * @param notation how to write settings in the commands that the page shows
   * @throws InputException if the folder does not contain what a page needs
   */
  public static String html(Path folder, String name, NamedSetting.Notation notation)
      throws IOException {
    if (!Files.isDirectory(folder)) {
      throw InputException.of(
          "no folder '%s', expected one that 'run' with %s or 'compare' wrote",
          folder, setting("record"));
    }
    if (TradeoffReport.suits(folder)) {
      return TradeoffReport.of(folder, name, notation).html();
    }
    Page page =
        ComparisonReport.suits(folder) ? ComparisonReport.of(folder, name) : RunReport.of(folder);
    return page.html();
  }
}
