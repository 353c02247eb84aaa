package org.hificamsim.network.files;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.core.file.SeparateFiles;
import org.hificamsim.network.Network;
import org.hificamsim.network.NetworkRun;
import org.hificamsim.network.statistics.OverlapTable;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.output.Detail;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.runs.output.RunTables;
import org.hificamsim.runs.output.SingleRun;

/** All files of one run: CamSim's two, and those of ours that are asked for. */
public final class CamSimFiles implements Closeable {
  /**
   * Where the files go.
   *
   * @param scenario the file that is read
   * @param output CamSim's table of steps
   * @param summary CamSim's summary; in the folder of the output unless given
   * @param extra the table of what CamSim's columns are taken for
   * @param coverage the folder of the run's k-coverage
   * @param force whether the table may be there; CamSim's own files are replaced
   */
  public record Places(
      Path scenario,
      Path output,
      Optional<Path> summary,
      Optional<Path> extra,
      Optional<Path> coverage,
      boolean force) {}

  private static final List<String> COVERAGE =
      List.of(RunTables.STEPS.file(), ResultFolder.SUMMARY, ResultFolder.MANIFEST);

  private final List<Closeable> opened = new ArrayList<>();
  private final List<OutputFile> files = new ArrayList<>();
  private final List<Closeable> tables = new ArrayList<>();
  private final Optional<SingleRun> coverage;
  private final SummaryRows summary;
  private final NetworkRun run;
  private final RunPlan plan;

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
    Network network = run.network();
    try {
      StepTable steps = opened(StepTable.camSim(file("-o", places.output(), true).open()));
      run.listen((view, measured) -> steps.camSim(network.figures()));
      if (places.extra().isPresent()) {
        StepTable extra =
            opened(
                StepTable.extra(file("--extra-out", places.extra().get(), places.force()).open()));
        OverlapTable overlap = OverlapTable.exact(run.world().cameras());
        run.listen((view, measured) -> extra.extra(network.figures(), overlap.sum()));
      }
      coverage =
          places.coverage().isPresent()
              ? Optional.of(
                  new SingleRun(places.coverage().get(), 0, plan.detection(), Detail.STEPS))
              : Optional.empty();
      coverage.ifPresent(opened::add);
      coverage.ifPresent(run::listen);
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
    places.extra().ifPresent(extra -> files.with("--extra-out", extra));
    if (places.coverage().isPresent()) {
      Path folder = places.coverage().get();
      files.with("--coverage-out", folder);
      COVERAGE.forEach(name -> files.with("--coverage-out", folder.resolve(name)));
    }
  }

  /** Moves the files into place and appends to the summary, after the run. */
  public void commit(List<String> command, Instant started) throws IOException {
    for (Closeable table : tables) {
      table.close();
    }
    if (coverage.isPresent()) {
      coverage.get().folder().manifest(command, started, plan.steps());
      coverage.get().commit(plan, run.traffic(), Optional.empty());
    }
    for (OutputFile file : files) {
      file.commit();
    }
    summary.append(plan.seed(), run.sums());
  }

  @Override
  public void close() throws IOException {
    closeFrom(0);
  }

  /** What was opened last first, and the others even if one cannot be closed. */
  private void closeFrom(int first) throws IOException {
    if (first < opened.size()) {
      Closeable one = opened.get(first);
      try (one) {
        closeFrom(first + 1);
      }
    }
  }

  private OutputFile file(String option, Path path, boolean replaces) {
    OutputFile file = OutputFile.of(option, path, replaces);
    files.add(file);
    opened.add(file);
    return file;
  }

  private <T extends Closeable> T opened(T table) {
    opened.add(table);
    tables.add(table);
    return table;
  }
}
