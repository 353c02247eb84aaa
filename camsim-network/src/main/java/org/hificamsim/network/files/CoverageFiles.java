package org.hificamsim.network.files;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.engine.RunCoverage;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.output.ManifestFile;
import org.hificamsim.runs.output.OutputFolder;
import org.hificamsim.runs.output.RunRecorder;
import org.hificamsim.runs.output.SummaryFile;

/** The k-coverage of a run of CamSim's network, in the files that {@code run} writes. */
final class CoverageFiles implements Closeable {
  private final RunPlan plan;
  private final OutputFolder folder;
  private final RunRecorder recorder;
  private final RunCoverage coverage = new RunCoverage();

  /** Opens the files. */
  CoverageFiles(Path path, RunPlan plan) throws IOException {
    this.plan = plan;
    folder = new OutputFolder(path);
    recorder = new RunRecorder(folder, false);
  }

  /** What has to watch the run. */
  List<StepListener> listeners() {
    return List.of(coverage, recorder.listener(0));
  }

  /**
   * Moves the files into place, after the run.
   *
   * @param messages how many StartSearch messages were delivered
   */
  void commit(List<String> command, Instant started, long messages) throws IOException {
    recorder.close();
    RunResult result = RunResult.of(0, plan.seed(), coverage, messages, Optional.empty());
    SummaryFile.write(folder.open("summary.json"), plan, List.of(result));
    ManifestFile.write(folder.open("manifest.json"), command, started, plan.steps());
    folder.commit(RunRecorder.RECORDS);
  }

  @Override
  public void close() throws IOException {
    recorder.close();
    folder.close();
  }
}
