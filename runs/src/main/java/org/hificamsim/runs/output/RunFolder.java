package org.hificamsim.runs.output;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.Closeable;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Rows;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;

/** The folder of a run under way: its tables row by row, and the other files at its end. */
public final class RunFolder implements Closeable {
  /** What not every run writes; of an earlier run it would be another run's. */
  private static final List<String> NOT_ALWAYS =
      Stream.concat(
              Stream.of(RunTables.STEPS, RunTables.ZOOMS, RunTables.TARGETS)
                  .flatMap(table -> TableFormat.NAMES.stream().map(table::file)),
              Stream.of(
                  ResultFolder.HEATMAP,
                  ResultFolder.MANIFEST,
                  ResultFolder.CRATE,
                  ResultFolder.REPLAY,
                  ResultFolder.REPORT))
          .toList();

  /** What every run writes, which has to be free before it begins. */
  private static final List<String> ALWAYS = List.of(ResultFolder.SUMMARY, ResultFolder.MANIFEST);

  private final OutputFolder folder;
  private final Table<StepCursor> stepTable;
  private final Table<StepCursor> cameraTable;
  private final Table<StepCursor> targetTable;
  private final Rows steps;
  private final Rows zooms;
  private final Rows targets;

  /**
   * Starts the tables.
   *
   * @param folder closed with this
   * @param detection of the run: by chance, tables have more columns
   * @param detail what is written of each step
   * @param format of the tables with a row for each step
   */
  public RunFolder(OutputFolder folder, Detection detection, Detail detail, TableFormat format)
      throws IOException {
    this.folder = folder;
    boolean record = detail != Detail.STEPS;
    stepTable = RunTables.steps(!detection.certain());
    cameraTable = detail == Detail.VIEWS ? RunTables.VIEWS : RunTables.ZOOMS;
    targetTable = detection.certain() ? RunTables.TARGETS : RunTables.TARGETS_BY_CHANCE;
    try {
      folder.claim(ALWAYS);
      zooms = record ? format.create(cameraTable, folder) : null;
      targets = record ? format.create(targetTable, folder) : null;
      steps = format.create(stepTable, folder);
    } catch (IOException | RuntimeException e) {
      folder.close(); // and its lock, for another try
      throw e;
    }
  }

  /** The listener that writes one repeat. */
  public StepListener listener(int run) {
    StepCursor at = new StepCursor();
    return (network, coverage) -> {
      at.network = network;
      stepTable.add(at.at(run, network.step(), coverage), steps);
      if (zooms != null) {
        zooms(at);
        targets(at);
      }
    };
  }

  private void zooms(StepCursor at) {
    for (at.camera = 0; at.camera < at.network.cameras(); at.camera++) {
      if (at.network.online(at.camera)) {
        cameraTable.add(at, zooms);
      }
    }
  }

  private void targets(StepCursor at) {
    for (at.target = 0; at.target < at.network.targets(); at.target++) {
      if (at.network.present(at.target)) {
        targetTable.add(at, targets);
      }
    }
  }

  /**
   * Ends the tables and adds {@code summary.json}: every setting, and the metrics of the repeats.
   */
  public void finish(RunPlan plan, List<RunResult> results) throws IOException {
    closeTables();
    ObjectNode json = SettingsFile.of(plan);
    List<Metric> metrics = Metric.ofRuns().stream().filter(results.get(0)::has).toList();
    metrics.forEach(metric -> mean(json, metric, results));
    if (results.size() > 1) {
      ObjectNode intervals = json.putObject("interval_95");
      for (Metric metric : metrics) {
        Estimate estimate = RunResult.mean(results, metric);
        intervals.putArray(metric.label()).add(estimate.low()).add(estimate.high());
      }
    }
    ArrayNode runs = json.putArray("runs");
    for (RunResult result : results) {
      ObjectNode run = runs.addObject().put("run", result.run()).put("seed", result.seed());
      metrics.forEach(metric -> run.set(metric.label(), JsonOutput.number(result.value(metric))));
      Arrays.stream(Metric.values())
          .filter(metric -> metric.isClaim() && result.has(metric))
          .forEach(metric -> run.set(metric.label(), JsonOutput.number(result.value(metric))));
    }
    JsonOutput.write(folder, ResultFolder.SUMMARY, json);
  }

  /** Of a single run, what is a sum over its steps is written as in the list of runs. */
  private static void mean(ObjectNode json, Metric metric, List<RunResult> results) {
    double mean = RunResult.mean(results, metric).mean();
    if (results.size() == 1 && (metric == Metric.PERFORMANCE || metric == Metric.SCORE)) {
      json.set(metric.label(), JsonOutput.number(mean));
    } else {
      json.put(metric.label(), mean);
    }
  }

  /** Moves all files into place. */
  public void commit() throws IOException {
    ResultFolder.commit(folder, NOT_ALWAYS);
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
