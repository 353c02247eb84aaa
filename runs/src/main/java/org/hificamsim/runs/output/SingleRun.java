package org.hificamsim.runs.output;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.FollowingSums;
import org.hificamsim.core.engine.RunCoverage;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.engine.TargetFollowing;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.scenario.spec.Following;
import org.hificamsim.runs.Measured;
import org.hificamsim.runs.Proof;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.Traffic;

/** Writes the folder of one run for programs that make the steps themselves. */
public final class SingleRun implements StepListener, Closeable {
  private final int run;
  private final OutputFolder files;
  private final RunFolder folder;
  private final StepListener rows;
  private final RunCoverage sums = new RunCoverage();

  /** The recorder of following; null unless it is measured. */
  private final TargetFollowing following;

  /**
   * Begins the folder.
   *
   * @param run the number of the run
   * @param detection the detection of the run
   * @param detail the detail of each step
   * @param following whether it is measured how cameras follow targets
   */
  public SingleRun(Path path, int run, Detection detection, Detail detail, Following following)
      throws IOException {
    this.run = run;
    this.following = following == Following.TARGETS ? new TargetFollowing() : null;
    files = new OutputFolder(path);
    folder = new RunFolder(files, detection, detail, TableFormat.CSV);
    rows = folder.listener(run);
  }

  @Override
  public void stepped(OracleView network, StepCoverage coverage) {
    sums.stepped(network, coverage);
    rows.stepped(network, coverage);
    if (following != null) {
      following.stepped(network, coverage);
    }
  }

  /** The number of steps so far. */
  public int steps() {
    return Math.toIntExact(sums.steps());
  }

  /** The folder of the files. */
  public OutputFolder folder() {
    return files;
  }

  /**
   * Moves the files into place.
   *
   * @param plan the settings and the seed of the run
   * @param traffic the traffic between the cameras
   * @param proof the proof of the policy; empty if it does not claim to be the best
   */
  public void commit(RunPlan plan, Traffic traffic, Optional<Proof> proof) throws IOException {
    Measured measured = new Measured(sums, plan.objective(), traffic, proof, followingSums());
    folder.finish(plan, List.of(RunResult.of(run, plan.seed(), measured)));
    folder.commit();
  }

  private FollowingSums followingSums() {
    return following == null ? FollowingSums.NONE : following.sums();
  }

  @Override
  public void close() throws IOException {
    folder.close();
  }
}
