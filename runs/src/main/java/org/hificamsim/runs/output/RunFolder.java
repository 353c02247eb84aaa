package org.hificamsim.runs.output;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.Closeable;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Rows;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;

/** Writes the folder of a run: its tables row by row, and the other files when it has ended. */
public final class RunFolder implements Closeable {
  /** Files that not every run writes; those of an earlier run are removed. */
  private static final List<String> OPTIONAL =
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

  /** The key in {@code summary.json} of the shares of zones that are seen as they demand. */
  public static final String ZONES = "zones";

  /** Files that every run writes. Before the run it is checked that they may be replaced. */
  private static final List<String> REQUIRED = List.of(ResultFolder.SUMMARY, ResultFolder.MANIFEST);

  private final OutputFolder folder;
  private final Table<StepCursor> stepTable;
  private final Table<StepCursor> cameraTable;
  private final Table<StepCursor> targetTable;
  private final Rows steps;
  private final Rows zooms;
  private final Rows targets;

  /**
   * Begins the tables.
   *
   * @param folder the folder, which is closed together with this object
   * @param detection the detection of the run; by chance, tables have more columns
   * @param detail the detail of each step
   * @param format the format of the tables of steps, cameras and targets
   */
  public RunFolder(OutputFolder folder, Detection detection, Detail detail, TableFormat format)
      throws IOException {
    this.folder = folder;
    boolean hasDetails = detail != Detail.STEPS;
    stepTable = RunTables.steps(!detection.certain());
    cameraTable = detail == Detail.VIEWS ? RunTables.VIEWS : RunTables.ZOOMS;
    targetTable = detection.certain() ? RunTables.TARGETS : RunTables.TARGETS_BY_CHANCE;
    try {
      folder.claim(REQUIRED);
      zooms = hasDetails ? format.create(cameraTable, folder) : null;
      targets = hasDetails ? format.create(targetTable, folder) : null;
      steps = format.create(stepTable, folder);
    } catch (IOException | RuntimeException e) {
      folder.close(); // releases its lock
      throw e;
    }
  }

  /** Returns a listener that writes one repeat. */
  public StepListener listener(int run) {
    StepCursor cursor = new StepCursor();
    return (network, coverage) -> {
      cursor.network = network;
      stepTable.add(cursor.moveTo(run, network.step(), coverage), steps);
      if (zooms != null) {
        zooms(cursor);
        targets(cursor);
      }
    };
  }

  private void zooms(StepCursor cursor) {
    for (cursor.camera = 0; cursor.camera < cursor.network.cameras(); cursor.camera++) {
      if (cursor.network.online(cursor.camera)) {
        cameraTable.add(cursor, zooms);
      }
    }
  }

  private void targets(StepCursor cursor) {
    for (cursor.target = 0; cursor.target < cursor.network.targets(); cursor.target++) {
      if (cursor.network.present(cursor.target)) {
        targetTable.add(cursor, targets);
      }
    }
  }

  /** Ends the tables, and adds {@code summary.json} with all settings and the repeats' metrics. */
  public void finish(RunPlan plan, List<RunResult> results) throws IOException {
    closeTables();
    ObjectNode json = SettingsFile.of(plan);
    List<Metric> metrics = Metric.ofRuns().stream().filter(results.get(0)::has).toList();
    metrics.forEach(metric -> putMean(json, plan, metric, results));
    if (results.size() > 1) {
      ObjectNode intervals = json.putObject("interval_95");
      for (Metric metric : metrics) {
        Estimate estimate = RunResult.mean(plan, results, metric);
        intervals.putArray(metric.label()).add(estimate.low()).add(estimate.high());
      }
    }
    Map<String, Double> zones = RunResult.zoneShares(results);
    if (!zones.isEmpty()) {
      ArrayNode shares = json.putArray(ZONES);
      zones.forEach((name, met) -> shares.addObject().put("name", name).put("met", met));
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

  /** Adds the mean of a metric; the sums of a single run are written without a fraction. */
  private static void putMean(
      ObjectNode json, RunPlan plan, Metric metric, List<RunResult> results) {
    double mean = RunResult.mean(plan, results, metric).mean();
    if (results.size() == 1 && (metric == Metric.PERFORMANCE || metric == Metric.SCORE)) {
      json.set(metric.label(), JsonOutput.number(mean));
    } else {
      json.put(metric.label(), mean);
    }
  }

  /** Moves all files into place. */
  public void commit() throws IOException {
    ResultFolder.commit(folder, OPTIONAL);
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
      steps.close(); // the others are closed even if this fails
    }
  }
}
