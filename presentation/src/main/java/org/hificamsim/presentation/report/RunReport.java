package org.hificamsim.presentation.report;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.CsvTable;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.presentation.replay.Frame;
import org.hificamsim.presentation.replay.PackedHeat;
import org.hificamsim.presentation.replay.RecordedRun;
import org.hificamsim.presentation.replay.Replay;
import org.hificamsim.presentation.replay.ReplayJson;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.heat.HeatTable;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.runs.output.RunTables;
import org.hificamsim.runs.output.StepCursor;
import org.hificamsim.runs.output.StepRow;

/** The page of a run that was recorded: made from its folder alone. */
final class RunReport {
  private static final ObjectMapper JSON = new ObjectMapper();
  private static final double ROUNDING = 1e-9;

  private final Path folder;
  private final Replay replay;
  private final JsonNode summary;

  /** Of the recorded frames, by run; of none in a folder of an earlier version. */
  private final Map<String, List<Double>> scores = new LinkedHashMap<>();

  private RunReport(Path folder) throws IOException {
    this.folder = folder;
    this.replay = Replay.read(folder);
    this.summary = new ResultFolder(folder).json(ResultFolder.SUMMARY);
  }

  /**
   * The page.
   *
   * @throws InputException when a file is missing, broken, or of another run than the rest
   */
  static Page of(Path folder) throws IOException {
    RunReport report = new RunReport(folder);
    report.checkOneRun();
    report.checkSteps();
    Setup setup = report.replay.setup();
    ObjectNode data = JSON.createObjectNode();
    data.set("replay", JSON.readTree(ReplayJson.of(report.replay)));
    if (HeatTable.TABLE.isIn(folder)) {
      data.set("heat", JSON.readTree(ReplayJson.of(report.heat())));
    }
    data.set("summary", report.figures());
    data.set("names", MetricNames.json());
    data.set("objective", JSON.valueToTree(report.objective()));
    data.putPOJO("scores", report.scores.values());
    ResultFolder files = new ResultFolder(folder);
    data.put("command", files.command());
    data.put("version", files.version());
    return new Page(
        "%s, %s, %s".formatted(setup.scenario(), setup.policy(), setup.detection()),
        "run-page.js",
        "runPage",
        JSON.writeValueAsString(data));
  }

  /** Of a folder that names none, the default. */
  private ObjectiveWords objective() {
    String text = summary.path("objective").asText();
    return ObjectiveWords.of(text.isEmpty() ? Objective.kMin() : Objective.parse(text));
  }

  private PackedHeat heat() throws IOException {
    long steps = replay.runs().get(0).steps() * replay.repeat();
    return PackedHeat.of(HeatTable.read(folder, replay.setup().field()), 0, steps);
  }

  private void checkOneRun() {
    Setup setup = replay.setup();
    check("scenario", setup.scenario());
    check("detection", setup.detection());
    check("policy", setup.policy());
    check("seed", Long.toString(setup.seed()));
    check("repeat", Integer.toString(replay.repeat()));
    check("steps", Long.toString(replay.runs().get(0).steps()));
  }

  private void check(String setting, String recorded) {
    String text = summary.path(setting).asText();
    if (!text.equals(recorded)) {
      throw InputException.of(
          "%s: %s is '%s', but %s says '%s', expected the files of one run",
          folder.resolve(ResultFolder.SUMMARY), setting, text, ResultFolder.REPLAY, recorded);
    }
  }

  /** What the page derives from the frames must be what {@code steps.csv} says. */
  private void checkSteps() throws IOException {
    Map<String, String> recorded = new HashMap<>();
    for (int i = 0; i < replay.runs().size(); i++) {
      addRows(recorded, replay.recording(folder, i));
    }
    double[] sums = {0, 0};
    boolean scored = summary.has("score_words"); // else of an earlier version
    Path file =
        StepRow.each(
            folder,
            row -> {
              String frame = recorded.remove(row.run() + "," + row.step());
              check(row, frame);
              sums[0] += row.kMin();
              sums[1] += scored ? row.score() : 0;
              if (scored && frame != null) {
                scores.computeIfAbsent(row.run(), any -> new ArrayList<>()).add(row.score());
              }
            });
    if (!recorded.isEmpty()) {
      String[] missing = Collections.min(recorded.keySet()).split(",");
      throw InputException.of(
          "%s: no row for run %s and step %s, expected the file of the run that was" + " recorded",
          file, missing[0], missing[1]);
    }
    checkSum("performance", "k_min", sums[0] / replay.repeat(), file.getFileName());
    if (scored) {
      checkSum("score", "scores", sums[1] / replay.repeat(), file.getFileName());
    }
  }

  /** The rows of {@code steps.csv} that a recording makes, by run and step. */
  private static void addRows(Map<String, String> rows, RecordedRun recording) throws IOException {
    StringWriter text = new StringWriter();
    StepCursor at = new StepCursor();
    try (CsvTable row = new CsvTable(text, "", ',', "")) {
      for (Frame frame : recording.frames()) {
        at.at(recording.run(), frame.step(), frame.measure());
        RunTables.RECORDED.add(at, row);
        String which = recording.run() + "," + frame.step();
        rows.put(which, text.toString().substring(which.length() + 1));
        text.getBuffer().setLength(0);
      }
    }
  }

  private static void check(StepRow row, String recorded) {
    if (recorded != null && !(row.measures() + ",").startsWith(recorded + ",")) {
      throw row.error(
          Texts.format(
              "'%s', but the recorded run has %s there, expected the files of one run",
              row.measures(), recorded));
    }
  }

  private void checkSum(String metric, String column, double mean, Path steps) {
    double said = summary.path(metric).asDouble(Double.NaN);
    if (!(Math.abs(said - mean) <= ROUNDING * Math.max(1, mean))) {
      throw InputException.of(
          "%s: %s is %s, but the %s of %s make %s, expected the files of one run",
          folder.resolve(ResultFolder.SUMMARY), metric, said, column, steps, mean);
    }
  }

  /** The settings, and each figure with its interval. */
  private ObjectNode figures() {
    ObjectNode figures = JSON.createObjectNode();
    ObjectNode settings = figures.putObject("settings");
    settings.setAll((ObjectNode) summary);
    settings.remove(List.of("runs", "interval_95", "score_words", "score_unit"));
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
