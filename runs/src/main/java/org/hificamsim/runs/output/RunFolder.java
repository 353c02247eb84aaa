package org.hificamsim.runs.output;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Rows;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;

/** The folder of a run under way: its tables row by row, and the files beside them at its end. */
public final class RunFolder implements Closeable {
  /** What not every run writes; of an earlier run it would be another run's. */
  private static final List<String> BESIDE =
      Stream.of(
              TableFormats.files(Table.RUN_STEPS),
              TableFormats.files(Table.RUN_ZOOMS),
              TableFormats.files(Table.RUN_TARGETS),
              List.of(
                  Table.HEATMAP.file(),
                  ResultFolder.MANIFEST,
                  ResultFolder.CRATE,
                  ResultFolder.REPLAY,
                  ResultFolder.REPORT))
          .flatMap(List::stream)
          .toList();

  private final SourceCommit commit = SourceCommit.asked();
  private final OutputFolder folder;
  private final Detail detail;
  private final Rows steps;
  private final TableRows zooms;
  private final TableRows targets;

  /**
   * Starts the tables.
   *
   * @param detection of the run: by chance, tables have more columns
   * @param detail what is written of each step
   * @param format of the tables with a row for each step
   */
  public RunFolder(Path path, Detection detection, Detail detail, TableFormat format)
      throws IOException {
    boolean certain = detection.certain();
    boolean record = detail != Detail.STEPS;
    this.detail = detail;
    folder = new OutputFolder(path);
    try {
      Table ofCameras = detail == Detail.VIEWS ? Table.RUN_VIEWS : Table.RUN_ZOOMS;
      zooms = record ? format.create(ofCameras, folder) : null;
      Table ofTargets = certain ? Table.RUN_TARGETS : Table.RUN_TARGETS_BY_CHANCE;
      targets = record ? format.create(ofTargets, folder) : null;
      Table ofSteps = certain ? Table.RUN_STEPS : Table.RUN_STEPS_BY_CHANCE;
      steps = format.createNumbers(ofSteps, folder);
    } catch (IOException | RuntimeException e) {
      folder.close(); // and its lock, for whoever tries again
      throw e;
    }
  }

  /** The listener that writes one repeat. */
  public StepListener listener(int run) {
    return (network, coverage) -> {
      step(run, network.step(), coverage);
      if (zooms != null) {
        zooms(run, network);
        targets(run, network, coverage);
      }
    };
  }

  private void step(int run, long step, StepCoverage coverage) {
    steps.add(run);
    steps.add(step);
    StepRow.addMeasures(steps, coverage);
    steps.end();
  }

  private void zooms(int run, NetworkView network) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        camera(run, network, camera);
      }
    }
  }

  private void camera(int run, NetworkView network, int camera) {
    int view = network.view(camera);
    zooms.add(run);
    zooms.add(network.step());
    zooms.add(network.cameraName(camera));
    zooms.add(view % network.zooms(camera));
    zooms.add(network.zoom(camera, view).radius());
    zooms.add(network.detected(camera));
    if (detail == Detail.VIEWS) {
      zooms.add(Math.toDegrees(network.pan(camera, view)));
      zooms.add(Math.toDegrees(network.zoom(camera, view).viewingAngle()));
      zooms.add(network.moving(camera) ? 1 : 0);
    }
    zooms.end();
  }

  private void targets(int run, NetworkView network, StepCoverage coverage) {
    for (int target = 0; target < network.targets(); target++) {
      if (network.present(target)) {
        target(run, network, coverage, target);
      }
    }
  }

  private void target(int run, NetworkView network, StepCoverage coverage, int target) {
    targets.add(run);
    targets.add(network.step());
    targets.add(network.targetName(target));
    targets.add(network.oracle().targetX(target));
    targets.add(network.oracle().targetY(target));
    if (coverage.byChance()) {
      targets.add(network.coverage(target));
      targets.add(coverage.expected().chanceOfOne(target));
      targets.add(coverage.expected().chanceOfMore(target));
    }
    targets.end();
  }

  /** Adds {@code manifest.json}. */
  public void manifest(List<String> command, Instant started, long steps) throws IOException {
    ManifestFile.write(folder, command, started, steps, commit);
  }

  /** Adds a table of its own. */
  public void add(TableWriter table) throws IOException {
    table.write(folder);
  }

  /** Writes a table into a folder. */
  @FunctionalInterface
  public interface TableWriter {
    void write(OutputFolder folder) throws IOException;
  }

  /** Adds the scenario and the detection model. */
  public void inputs(RunPlan plan) throws IOException {
    InputFiles.write(folder, List.of(plan));
  }

  /** The files that are in their place, each with its SHA-256. */
  public Map<String, String> written() {
    return folder.written();
  }

  /** Adds {@code replay.json}, which the caller fills and closes. */
  public OutputStream replay() throws IOException {
    return folder.stream(ResultFolder.REPLAY);
  }

  /** Adds {@code summary.json} and moves all files into place. */
  public void commit(RunPlan plan, List<RunResult> results) throws IOException {
    closeTables();
    SummaryFile.write(folder, plan, results);
    ResultFolder.commit(folder, BESIDE);
  }

  @Override
  public void close() throws IOException {
    try (folder) {
      closeTables();
    }
  }

  private void closeTables() throws IOException {
    try (targets;
        zooms) {
      steps.close(); // and the others even if this one cannot be
    }
  }
}
