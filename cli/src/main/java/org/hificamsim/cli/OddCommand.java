package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.presentation.odd.OddProtocol;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code hificamsim odd}: a run as an ODD protocol, to be finished by hand. */
@Command(
    name = "odd",
    description = "Describes a run in the seven elements of the ODD protocol, as Markdown.")
final class OddCommand implements Callable<Integer> {
  @Parameters(paramLabel = "SCENARIO.xml", description = "The scenario file.")
  private Path file;

  @Mixin private ModelOptions models;

  @Mixin private ScenarioOptions scenarioOptions;

  @Mixin private RepeatOptions repeats;

  @Option(
      names = "--out",
      paramLabel = "FILE.md",
      description = "Where the text goes; without it, to the screen.")
  private Optional<Path> out;

  @Mixin private Screen screen;

  @Override
  public Integer call() throws IOException {
    Catalogue catalogue = Catalogue.load();
    Scenario scenario = scenarioOptions.read(file, catalogue, screen.err());
    RunPlan plan =
        repeats.plan(
            scenario,
            scenarioOptions.detection(models.detection(catalogue), scenario),
            models.policy().orElseThrow());
    new RunExecutor(catalogue).check(plan);
    String text = OddProtocol.of(plan, catalogue);
    if (out.isPresent()) {
      OutputFile.of("--out", out.get()).write(text);
    } else {
      screen.out().print(text);
      screen.out().flush();
    }
    return 0;
  }
}
