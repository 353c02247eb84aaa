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
import org.hificamsim.network.Network;
import org.hificamsim.network.NetworkRun;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.output.Detail;
import org.hificamsim.runs.output.ManifestFile;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.runs.output.RunTables;
import org.hificamsim.runs.output.SingleRun;

/** All files of one run: CamSim's two, which are replaced, and those of ours that are asked for. */
public final class CamSimFiles implements Closeable {
  /**
   * Where the files go.
   *
   * @param scenario the file that is read
   * @param output CamSim's table of steps
   * @param summary CamSim's summary; in the folder of the output unless given
   * @param coverage the folder of the run's k-coverage
   */
  public record Places(
      Path scenario, Path output, Optional<Path> summary, Optional<Path> coverage) {}

  private static final List<String> COVERAGE =
      List.of(RunTables.STEPS.file(), ResultFolder.SUMMARY, ResultFolder.MANIFEST);

  private final OutputFile file;
  private final SummaryRows summary;
  private final NetworkRun run;
  private final RunPlan plan;

  /** Null if the file cannot be opened. */
  private StepTable steps;

  /** Null unless coverage was asked for. */
  private SingleRun coverage;

  /**
   * Opens the files of a run that is to begin, and has them listen to it.
   *
   * @throws org.hificamsim.core.InputException when one of them cannot be made, or two are one
   */
  public CamSimFiles(Places places, RunPlan plan, NetworkRun run) throws IOException {
    this.plan = plan;
    this.run = run;
    Path appended = places.summary().orElse(SummaryRows.beside(places.output()));
    requireSeparate(places, appended);
    summary = new SummaryRows(appended);
    file = OutputFile.of("-o", places.output(), true);
    Network network = run.network();
    try {
      steps = new StepTable(file.open());
      run.listen((view, measured) -> steps.add(network.figures()));
      if (places.coverage().isPresent()) {
        coverage = new SingleRun(places.coverage().get(), 0, plan.detection(), Detail.STEPS);
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
      COVERAGE.forEach(name -> files.with(setting("coverage_out"), folder.resolve(name)));
    }
  }

  /** Moves the files into place and appends to the summary, after the run. */
  public void commit(List<String> command, Instant started) throws IOException {
    steps.close();
    if (coverage != null) {
      ManifestFile.write(coverage.folder(), command, started, plan.steps());
      coverage.commit(plan, run.traffic(), Optional.empty());
    }
    file.commit();
    summary.append(plan.seed(), run.sums());
  }

  /** All are closed, even if one cannot be. */
  @Override
  public void close() throws IOException {
    Closeable table = steps;
    Closeable folder = coverage;
    try (file;
        table;
        folder) {
      // nothing more to do
    }
  }
}
