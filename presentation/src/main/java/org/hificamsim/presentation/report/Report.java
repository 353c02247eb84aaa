package org.hificamsim.presentation.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFile;

/** Makes the page of a folder that a command has written. */
public final class Report {
  private Report() {}

  /**
   * Writes the page.
   *
   * @param out where to, beside nothing that it needs
   * @throws InputException when the folder does not hold what a page is made of
   */
  public static void write(Path folder, Path out) throws IOException {
    if (!Files.isDirectory(folder)) {
      throw new InputException(
          "no folder '"
              + folder
              + "', expected one that 'hificamsim run --record' or 'hificamsim compare' wrote");
    }
    String html = page(folder).html();
    OutputFile.of("--out", out).write(html);
  }

  private static Page page(Path folder) throws IOException {
    return ComparisonReport.suits(folder) ? ComparisonReport.of(folder) : RunReport.of(folder);
  }
}
