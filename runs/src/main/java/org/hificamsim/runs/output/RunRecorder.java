package org.hificamsim.runs.output;

import java.io.Closeable;
import java.io.IOException;
import java.util.List;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;

/** Writes the per-step tables of a run: {@code steps.csv}, and if asked zooms and targets. */
public final class RunRecorder implements Closeable {
  private static final String ZOOMS = "zooms.csv";
  private static final String TARGETS = "targets.csv";

  /** The files of {@code --record}: its tables, and what is made of them. */
  public static final List<String> RECORDS = List.of(ZOOMS, TARGETS, "replay.json", "report.html");

  private final CsvTable steps;
  private final CsvTable zooms;
  private final CsvTable targets;

  /**
   * @param full whether zooms and targets are written too
   */
  public RunRecorder(OutputFolder folder, boolean full) throws IOException {
    steps =
        new CsvTable(
            folder.open("steps.csv"),
            "run",
            "step",
            "k_min",
            "targets",
            "covered_0",
            "covered_1",
            "covered_k",
            "mean_k");
    zooms =
        full
            ? new CsvTable(
                folder.open(ZOOMS), "run", "step", "camera", "level", "radius", "detected")
            : null;
    targets = full ? new CsvTable(folder.open(TARGETS), "run", "step", "target", "x", "y") : null;
  }

  /** The listener that writes one repeat. */
  public StepListener listener(int run) {
    return (network, coverage) -> {
      step(run, network.step(), coverage);
      if (zooms != null) {
        zooms(run, network);
        targets(run, network);
      }
    };
  }

  private void step(int run, long step, StepCoverage coverage) {
    steps.row(
        run,
        step,
        coverage.kMin(),
        coverage.targets(),
        coverage.covered0(),
        coverage.covered1(),
        coverage.coveredK(),
        coverage.meanK());
  }

  private void zooms(int run, NetworkView network) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        int level = network.level(camera);
        zooms.row(
            run,
            network.step(),
            network.cameraName(camera),
            level,
            network.zoom(camera, level).radius(),
            network.detected(camera));
      }
    }
  }

  private void targets(int run, NetworkView network) {
    for (int target = 0; target < network.targets(); target++) {
      if (network.present(target)) {
        targets.row(
            run,
            network.step(),
            network.targetName(target),
            network.oracle().targetX(target),
            network.oracle().targetY(target));
      }
    }
  }

  @Override
  public void close() throws IOException {
    steps.close();
    if (zooms != null) {
      zooms.close();
      targets.close();
    }
  }
}
