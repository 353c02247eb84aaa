package org.hificamsim.bridge.run;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.engine.RunCoverage;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.experiments.output.OutputFolder;
import org.hificamsim.experiments.output.RunRecorder;
import org.hificamsim.experiments.output.SummaryFile;
import org.hificamsim.experiments.run.RunPlan;
import org.hificamsim.experiments.run.RunResult;

/** The files of one run, as {@code hificamsim run --record} writes them. */
final class Recording {
  private final int run;
  private final OutputFolder folder;
  private final RunRecorder recorder;
  private final RunCoverage sums = new RunCoverage();
  private final StepListener rows;
  private boolean started;

  /**
   * Opens the files.
   *
   * @param run number of the run in this JVM, from 0
   */
  Recording(Path path, int run) throws IOException {
    this.run = run;
    folder = new OutputFolder(path);
    recorder = new RunRecorder(folder, true);
    rows = recorder.listener(run);
  }

  /** Writes the rows of a step. */
  void stepped(NetworkView network, StepCoverage coverage) {
    if (!started) {
      sums.started(network);
      started = true;
    }
    sums.stepped(network, coverage);
    rows.stepped(network, coverage);
  }

  /** The number of steps written. */
  int steps() {
    return Math.toIntExact(sums.steps());
  }

  /**
   * Moves the files into place.
   *
   * @param plan the run's settings, and its seed
   */
  void commit(RunPlan plan, long messages) throws IOException {
    recorder.close();
    RunResult result = RunResult.of(run, plan.seed(), sums, messages);
    SummaryFile.write(folder.open("summary.json"), plan, List.of(result));
    folder.commit(List.of());
  }
}
