package org.hificamsim.presentation.odd;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioEvent;
import org.hificamsim.core.scenario.TargetSpec;

/** The tables of an ODD protocol. Long ones end with where the rest is. */
final class OddTables {
  private static final int MAX_ROWS = 50;

  private OddTables() {}

  static String cameras(Scenario scenario) {
    List<String> rows = scenario.cameras().stream().map(OddTables::camera).toList();
    return table("| camera | x (m) | y (m) | heading (degrees) | opening angle (degrees) |", rows);
  }

  private static String camera(CameraSpec camera) {
    return row(
        camera.name(),
        OddProtocol.plain(camera.x()),
        OddProtocol.plain(camera.y()),
        OddProtocol.plain(camera.heading()),
        OddProtocol.plain(camera.viewingAngle()));
  }

  static String targets(Scenario scenario) {
    List<String> rows = scenario.targets().stream().map(OddTables::target).toList();
    return table("| target | x (m) | y (m) | speed (m a step) | size (m) | movement |", rows);
  }

  private static String target(TargetSpec target) {
    return row(
        target.name(),
        OddProtocol.plain(target.x()),
        OddProtocol.plain(target.y()),
        OddProtocol.plain(target.speed()),
        OddProtocol.plain(target.size()),
        target.movement().shortName());
  }

  static String events(Scenario scenario) {
    List<String> rows =
        scenario.events().stream().map(event -> row("" + event.step(), text(event))).toList();
    return table("| step | event |", rows);
  }

  private static String text(ScenarioEvent event) {
    if (event instanceof ScenarioEvent.AddCamera add) {
      return "camera " + add.camera().name() + " is added";
    }
    if (event instanceof ScenarioEvent.ChangeCamera change) {
      return "camera " + change.camera() + " is moved, turned or given another range";
    }
    if (event instanceof ScenarioEvent.FailCamera fail) {
      return "camera " + fail.camera() + " goes offline";
    }
    if (event instanceof ScenarioEvent.AddTarget add) {
      return "target " + add.target().name() + " appears";
    }
    if (event instanceof ScenarioEvent.RemoveTarget remove) {
      return "target " + remove.features() + " disappears";
    }
    return "the global registration goes offline";
  }

  static String options(List<Options.Declared> options) {
    return table(
        "| option | default | meaning |",
        options.stream()
            .map(one -> row("`" + one.key() + "`", one.defaultValue(), one.meaning()))
            .toList());
  }

  private static String table(String header, List<String> rows) {
    int columns = header.length() - header.replace("|", "").length() - 1;
    List<String> lines = new ArrayList<>(List.of(header, "|" + "---|".repeat(columns)));
    lines.addAll(rows.subList(0, Math.min(MAX_ROWS, rows.size())));
    String rest =
        rows.size() > MAX_ROWS
            ? String.format(
                Locale.ROOT, "\n%s more are in the scenario file.\n", rows.size() - MAX_ROWS)
            : "";
    return String.join("\n", lines) + "\n" + rest;
  }

  /** A row; a name may hold what Markdown takes for a column's end. */
  private static String row(String... cells) {
    return List.of(cells).stream()
        .map(cell -> cell.replace("|", "\\|"))
        .collect(Collectors.joining(" | ", "| ", " |"));
  }
}
