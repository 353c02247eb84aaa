package org.hificamsim.cli;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.placement.output.PlanFiles;
import org.hificamsim.placement.output.TitleBlock;
import org.hificamsim.placement.site.SitePlan;
import picocli.CommandLine.Option;

/** The options of {@code place} for optional files, and for the title block of documents. */
final class PlanFileOptions {
  @Option(names = "--write-candidates")
  private boolean candidates;

  @Option(names = "--title", paramLabel = "KEY=VALUE")
  private Map<String, String> entries = new LinkedHashMap<>();

  @Option(names = "--currency", paramLabel = "CODE")
  private Optional<String> currency;

  /**
   * The title block of the document.
   *
   * @param usual the currency of the catalogue
   */
  TitleBlock title(String usual) {
    return new TitleBlock(entries, currency.orElse(usual));
  }

  /** Adds the optional files that are asked for. */
  void write(OutputFolder folder, SitePlan plan) throws IOException {
    if (candidates) {
      PlanFiles.writeCandidates(folder, plan);
    }
  }
}
