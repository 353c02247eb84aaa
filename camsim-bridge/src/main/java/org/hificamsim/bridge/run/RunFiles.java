package org.hificamsim.bridge.run;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.engine.RunCoverage;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.runs.Proof;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.output.OutputFolder;
import org.hificamsim.runs.output.RunRecorder;
import org.hificamsim.runs.output.SummaryFile;

/**
 * The files of one run, as {@code hificamsim run --record} writes them: {@code steps.csv}, {@code
 * zooms.csv}, {@code targets.csv} and {@code summary.json}.
 */
final class RunFiles {
  private final int run;
  private final OutputFolder folder;
  private final RunRecorder recorder;
  private final RunCoverage sums = new RunCoverage();
  private final StepListener rows;

  /**
   * Opens the files.
   *
   * @param run number of the run in this JVM, from 0
   */
  RunFiles(Path path, int run) throws IOException {
    this.run = run;
    folder = new OutputFolder(path);
    recorder = new RunRecorder(folder, true);
    rows = recorder.listener(run);
  }

  /** Writes the rows of a step. */
  void stepped(NetworkView network, StepCoverage coverage) {
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
   * @param proof what the policy proved; empty under one that does not claim to be the best
   */
  void commit(RunPlan plan, long messages, Optional<Proof> proof) throws IOException {
    recorder.close();
    RunResult result = RunResult.of(run, plan.seed(), sums, messages, proof);
    SummaryFile.write(folder.open("summary.json"), plan, List.of(result));
    folder.commit(List.of());
  }
}
