package org.hificamsim.presentation.report;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.awt.Color;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.NamedSetting;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.data.CsvRow;
import org.hificamsim.data.CsvRows;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.runs.output.Table;

/** Makes the page of a study of CamSim's network from its folder. */
public final class TradeoffReport {
  private static final Table<?> NETWORKS = Table.of("networks.csv");
  private static final List<String> KINDS = List.of("heterogeneous", "bandit", "homogeneous");
  private static final List<Color> COLORS = List.of(Palette.SKY, Palette.VERMILION, Palette.BLUE);
  private static final String REPLAY_PREFIX = "replay-";

  /** The share of a panel that dots are in, so that none is cut off. */
  private static final double CONTENT_SHARE = 0.94;

  /** Settings that are options of {@code run}. */
  private static final List<String> OPTIONS =
      List.of("detection", "channel", "policy", "steps", "seed");

  private TradeoffReport() {}

  /** Whether a folder has a study. */
  public static boolean suits(Path folder) {
    return NETWORKS.isIn(folder);
  }

  static Page of(Path folder, String name, NamedSetting.Notation notation) throws IOException {
    ResultFolder files = new ResultFolder(folder);
    ObjectNode data = new ObjectMapper().createObjectNode();
    CsvRows networks = NETWORKS.read(folder);
    ComparisonReport.write(data.putObject("networks"), networks, Integer.MAX_VALUE);
    for (String table : List.of("fronts", "verdicts")) {
      ComparisonReport.write(
          data.putObject(table), Table.of(table + ".csv").read(folder), Integer.MAX_VALUE);
    }
    ObjectNode cameras = data.putObject("cameras");
    ObjectNode runs = data.putObject("runs");
    for (JsonNode plan : files.json(ResultFolder.SETTINGS)) {
      String scenario = plan.path("scenario").asText();
      Path copy = folder.resolve("scenario-" + scenario + ".xml");
      ArrayNode names = cameras.putArray(scenario);
      ScenarioReader.read(copy, movement -> true, warning -> {})
          .cameras()
          .forEach(camera -> names.add(camera.name()));
      runs.put(
          scenario, "./hificamsim " + String.join(" ", run(plan, folder, "NETWORK", notation)));
    }
    ObjectNode replays = data.putObject("replays");
    for (CsvRow row : networks.rows()) {
      String network = row.text("scenario") + "-" + row.text("network");
      String page = REPLAY_PREFIX + network + "/report.html";
      if (Files.isRegularFile(folder.resolve(page))) {
        replays.put(network, page);
      }
    }
    data.put("command", files.command());
    data.put("version", files.version());
    data.put("title", name);
    return new Page(name, "tradeoff-page.js", "tradeoffPage", data.toString());
  }

  /** Draws utility against cost of all networks, with a panel for each scenario. */
  public static Figure figure(Path folder) {
    List<CsvRow> rows = NETWORKS.read(folder).rows();
    List<XyPanel> panels = new ArrayList<>();
    for (String scenario : rows.stream().map(row -> row.text("scenario")).distinct().toList()) {
      XyPanel panel = new XyPanel(scenario, "messages", "utility");
      List<CsvRow> networks =
          rows.stream().filter(row -> row.text("scenario").equals(scenario)).toList();
      for (int i = 0; i < KINDS.size(); i++) {
        String kind = KINDS.get(i);
        List<CsvRow> ofKind =
            networks.stream().filter(row -> row.text("kind").equals(kind)).toList();
        if (!ofKind.isEmpty()) {
          panel.dots(new Curve(values(ofKind, "cost"), values(ofKind, "utility")), COLORS.get(i));
        }
      }
      panel.straight(steps(front(folder, scenario, networks)), Palette.BLACK);
      panel.getStyler().setPlotContentSize(CONTENT_SHARE);
      panels.add(panel);
    }
    List<LegendEntry> legend =
        IntStream.range(0, KINDS.size())
            .mapToObj(i -> new LegendEntry(KINDS.get(i), COLORS.get(i), LegendEntry.Mark.DOT))
            .toList();
    int columns = Math.min(3, panels.size());
    return new Figure(
        "Utility for messages", "Means over seeds.", legend, panels, columns, 340, 280);
  }

  /** The networks on the front of strategies that never change, by rising cost. */
  private static List<CsvRow> front(Path folder, String scenario, List<CsvRow> networks) {
    return Table.of("fronts.csv").read(folder).rows().stream()
        .filter(row -> row.text("scenario").equals(scenario))
        .filter(row -> row.text("networks").equals("static"))
        .flatMap(row -> Stream.of(row.text("front").split(" ")))
        .flatMap(name -> networks.stream().filter(row -> row.text("network").equals(name)))
        .toList();
  }

  /** The border of what a front beats, as steps. */
  private static Curve steps(List<CsvRow> front) {
    double[] cost = values(front, "cost");
    double[] utility = values(front, "utility");
    int corners = Math.max(0, 2 * cost.length - 1);
    return new Curve(
        IntStream.range(0, corners).mapToDouble(i -> cost[(i + 1) / 2]).toArray(),
        IntStream.range(0, corners).mapToDouble(i -> utility[i / 2]).toArray());
  }

  private static double[] values(List<CsvRow> rows, String column) {
    return rows.stream().mapToDouble(row -> row.numberOrNaN(column)).toArray();
  }

  /**
   * Returns the commands that record the first seed of each network of the fronts, in the study's
   * folder.
   *
   * @param notation the notation of the commands' settings
   */
  public static List<List<String>> replays(Path folder, NamedSetting.Notation notation)
      throws IOException {
    List<List<String>> commands = new ArrayList<>();
    CsvRows networks = NETWORKS.read(folder);
    for (JsonNode plan : new ResultFolder(folder).json(ResultFolder.SETTINGS)) {
      String scenario = plan.path("scenario").asText();
      for (CsvRow row : networks.rows()) {
        if (row.text("scenario").equals(scenario) && row.numberOrNaN("below_front") <= 0) {
          List<String> words = new ArrayList<>(run(plan, folder, row.text("option"), notation));
          String replay = REPLAY_PREFIX + scenario + "-" + row.text("network");
          words.addAll(
              List.of(
                  notation.name("quiet"), notation.name("out"), folder.resolve(replay).toString()));
          commands.add(words);
        }
      }
    }
    return commands;
  }

  /** Returns the command that records the first seed of a network, by the settings of a plan. */
  private static List<String> run(
      JsonNode plan, Path folder, String network, NamedSetting.Notation notation) {
    String copy = "scenario-" + plan.path("scenario").asText() + ".xml";
    List<String> words =
        new ArrayList<>(
            List.of(
                "run",
                folder.resolve(copy).toString(),
                notation.name("record"),
                notation.name("network"),
                network));
    for (String setting : OPTIONS) {
      if (plan.has(setting)) {
        words.addAll(List.of(notation.name(setting), plan.get(setting).asText()));
      }
    }
    return words;
  }
}
