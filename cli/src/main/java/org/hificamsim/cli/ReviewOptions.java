package org.hificamsim.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hificamsim.placement.output.PlanFiles;
import picocli.CommandLine.Option;

/** The options of {@code place} that measure existing plans instead of planning. */
final class ReviewOptions {
  @Option(names = "--evaluate", paramLabel = "PLAN.xml")
  private Optional<Path> evaluated;

  @Option(names = "--compare", arity = "2", paramLabel = "PLAN.xml")
  private List<Path> compared = List.of();

  /** The scenarios of the plans: none, one to evaluate, or two to compare. */
  List<Path> plans() {
    List<Path> given = evaluated.map(List::of).orElse(compared);
    return given.stream()
        .map(path -> Files.isDirectory(path) ? path.resolve(PlanFiles.SCENARIO) : path)
        .toList();
  }
}
