package org.hificamsim.presentation.report;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.core.InputException;
import org.hificamsim.runs.output.OutputFile;

/** Makes the page of a folder that a command has written. */
public final class Report {
  /** The page's name where nobody says another. */
  public static final String FILE = "report.html";

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
    try (OutputFile file = new OutputFile("--out", out)) {
      try (Writer writer = file.open()) {
        writer.write(html);
      }
      file.commit();
    }
  }

  private static Page page(Path folder) throws IOException {
    return ComparisonReport.suits(folder) ? ComparisonReport.of(folder) : RunReport.of(folder);
  }
}
