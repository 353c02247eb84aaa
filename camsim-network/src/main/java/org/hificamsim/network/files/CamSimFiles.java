package org.hificamsim.network.files;

import static org.hificamsim.core.NamedSetting.setting;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.core.file.SeparateFiles;
import org.hificamsim.core.scenario.spec.Following;
import org.hificamsim.network.Network;
import org.hificamsim.network.NetworkRun;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.output.Detail;
import org.hificamsim.runs.output.ManifestFile;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.runs.output.RunTables;
import org.hificamsim.runs.output.SingleRun;

/** All files of one run: CamSim's step table and summary, and optionally our coverage files. */
public final class CamSimFiles implements Closeable {
  /**
   * The paths of the files.
   *
   * @param scenario the scenario file, which is read
   * @param output CamSim's table of steps
   * @param summary CamSim's summary; empty for the folder of the output
   * @param coverage the folder for the k-coverage of the run; empty for none
   */
  public record Places(
      Path scenario, Path output, Optional<Path> summary, Optional<Path> coverage) {}

  private static final List<String> COVERAGE_FILES =
      List.of(RunTables.STEPS.file(), ResultFolder.SUMMARY, ResultFolder.MANIFEST);

  private final OutputFile stepsFile;
  private final SummaryRows summary;
  private final NetworkRun run;
  private final RunPlan plan;

  /** The table of steps; null if {@link #stepsFile} cannot be opened. */
  private StepTable steps;

  /** The run whose coverage is written; null unless coverage was asked for. */
  private SingleRun coverage;

  /**
   * Opens the files of a run that has not begun, and registers them as listeners.
   *
   * @throws org.hificamsim.core.InputException if a file cannot be created, or two paths are the
   *     same
   */
  public CamSimFiles(Places places, RunPlan plan, NetworkRun run) throws IOException {
    this.plan = plan;
    this.run = run;
    Path summaryPath = places.summary().orElse(SummaryRows.defaultPath(places.output()));
    requireSeparate(places, summaryPath);
    summary = new SummaryRows(summaryPath);
    stepsFile = OutputFile.of("-o", places.output(), true);
    Network network = run.network();
    try {
      steps = new StepTable(stepsFile.open());
      run.listen((view, measured) -> steps.add(network.figures()));
      if (places.coverage().isPresent()) {
        coverage =
            new SingleRun(
                places.coverage().get(), 0, plan.detection(), Detail.STEPS, Following.NONE);
        run.listen(coverage);
      }
    } catch (IOException | RuntimeException e) {
      close();
      throw e;
    }
  }

  private static void requireSeparate(Places places, Path summary) {
    SeparateFiles files =
        new SeparateFiles()
            .with("the scenario", places.scenario())
            .with("-o", places.output())
            .with(places.summary().isPresent() ? "-f" : "the default of -f", summary);
    if (places.coverage().isPresent()) {
      Path folder = places.coverage().get();
      files.with(setting("coverage_out"), folder);
      COVERAGE_FILES.forEach(name -> files.with(setting("coverage_out"), folder.resolve(name)));
    }
  }

  /** Moves the files into place and appends to the summary, after the run. */
  public void commit(List<String> command, Instant started) throws IOException {
    steps.close();
    if (coverage != null) {
      ManifestFile.write(coverage.folder(), command, started, plan.steps());
      coverage.commit(plan, run.traffic(), Optional.empty());
    }
    stepsFile.commit();
    summary.append(plan.seed(), run.sums());
  }

  /** Closes all files, even if closing one of them fails. */
  @Override
  public void close() throws IOException {
    Closeable table = steps;
    Closeable folder = coverage;
    try (stepsFile;
        table;
        folder) {
      // Try-with-resources closes all three.
    }
  }
}
