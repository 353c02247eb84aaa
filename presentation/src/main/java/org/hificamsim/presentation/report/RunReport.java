package org.hificamsim.presentation.report;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.presentation.replay.PackedHeat;
import org.hificamsim.presentation.replay.RecordedRun;
import org.hificamsim.presentation.replay.Replay;
import org.hificamsim.presentation.replay.ReplayJson;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.heat.HeatTable;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.runs.output.RunFolder;
import org.hificamsim.runs.output.StepRow;

/** Makes the page of a recorded run from its folder. */
final class RunReport {
  private static final ObjectMapper JSON = new ObjectMapper();

  private final Path folder;
  private final Replay replay;
  private final JsonNode summary;

  private RunReport(Path folder) throws IOException {
    this.folder = folder;
    this.replay = Replay.read(folder);
    this.summary = new ResultFolder(folder).json(ResultFolder.SUMMARY);
  }

  /**
   * Makes the page.
   *
   * @throws InputException if a file is missing or broken
   */
  static Page of(Path folder) throws IOException {
    RunReport report = new RunReport(folder);
    report.requireOneRun();
    Setup setup = report.replay.setup();
    ObjectNode data = JSON.createObjectNode();
    data.set("replay", JSON.readTree(ReplayJson.of(report.replay)));
    if (HeatTable.TABLE.isIn(folder)) {
      data.set("heat", JSON.readTree(ReplayJson.of(report.heat())));
    }
    data.set("zones", report.summary.path(RunFolder.ZONES));
    data.set("summary", report.figures());
    data.set("names", MetricNames.json());
    data.set("objective", JSON.valueToTree(report.objective()));
    data.putPOJO("scores", report.scores());
    ResultFolder files = new ResultFolder(folder);
    data.put("command", files.command());
    data.put("version", files.version());
    return new Page(
        "%s, %s, %s".formatted(setup.scenario(), setup.policy(), setup.detection()),
        "run-page.js",
        "runPage",
        JSON.writeValueAsString(data));
  }

  /**
   * Checks that all files are of one run, because the folder may have no record of hashes.
   *
   * @throws InputException if they are not
   */
  private void requireOneRun() {
    Setup setup = replay.setup();
    requireSame("scenario", setup.scenario());
    requireSame("detection", setup.detection());
    requireSame("policy", setup.policy());
    requireSame("seed", Long.toString(setup.seed()));
  }

  private void requireSame(String setting, String recorded) {
    String text = summary.path(setting).asText();
    if (!text.equals(recorded)) {
      throw InputException.of(
          "%s: %s is '%s', but %s says '%s', expected the files of one run",
          folder.resolve(ResultFolder.SUMMARY), setting, text, ResultFolder.REPLAY, recorded);
    }
  }

  /** The objective of the run; the default one if the folder names none. */
  private ObjectiveWords objective() {
    String text = summary.path("objective").asText();
    return ObjectiveWords.of(text.isEmpty() ? Objective.kMin() : Objective.parse(text));
  }

  private PackedHeat heat() throws IOException {
    long steps = replay.runs().get(0).steps() * replay.repeat();
    return PackedHeat.of(HeatTable.read(folder, replay.setup().field()), 0, steps);
  }

  /**
   * The scores of the recorded frames, by run.
   *
   * @throws InputException if a frame has no score; tables of version 0.1 have none
   */
  private Collection<List<Double>> scores() throws IOException {
    if (!summary.has("score_words")) {
      throw InputException.of(
          "%s: no score_words, expected what 'run' writes since version 0.2",
          folder.resolve(ResultFolder.SUMMARY));
    }
    Map<Integer, List<Double>> scores = new LinkedHashMap<>();
    Set<String> missing = new HashSet<>();
    for (int i = 0; i < replay.runs().size(); i++) {
      RecordedRun run = replay.recording(folder, i);
      run.frames().forEach(frame -> missing.add(run.run() + "," + frame.step()));
    }
    Path file =
        StepRow.forEachRow(
            folder,
            row -> {
              if (missing.remove(row.run() + "," + row.step())) {
                scores.computeIfAbsent(row.run(), run -> new ArrayList<>()).add(row.score());
              }
            });
    if (!missing.isEmpty()) {
      throw InputException.of(
          "%s: no row for run,step %s, expected one for each step that was recorded",
          file, Collections.min(missing));
    }
    return scores.values();
  }

  /** The settings, and each metric with its interval. */
  private ObjectNode figures() {
    ObjectNode figures = JSON.createObjectNode();
    ObjectNode settings = figures.putObject("settings");
    settings.setAll((ObjectNode) summary);
    settings.remove(List.of("runs", RunFolder.ZONES, "interval_95", "score_words", "score_unit"));
    figures.put("repeat", replay.repeat());
    ObjectNode metrics = figures.putObject("metrics");
    for (Metric metric : Metric.ofRuns()) {
      JsonNode mean = settings.remove(metric.label());
      if (mean == null) {
        continue;
      }
      JsonNode interval = summary.path("interval_95").path(metric.label());
      ObjectNode figure = metrics.putObject(metric.label());
      figure.set("mean", mean);
      figure.set("low", interval.isArray() ? interval.get(0) : mean);
      figure.set("high", interval.isArray() ? interval.get(1) : mean);
    }
    return figures;
  }
}
