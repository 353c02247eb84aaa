package org.hificamsim.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.Texts;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.hints.DetectionHints;
import picocli.CommandLine.Option;

/** How scenario files are read: with their settings, and {@code --strict}. */
final class ScenarioOptions {
  @Option(names = "--strict")
  private boolean strict;

  /** Whether warnings are errors. */
  boolean strict() {
    return strict;
  }

  /** What a warning says where it is an error. */
  static String asError(String warning) {
    return warning + "; expected no warning, with --strict";
  }

  /** Takes warnings: each is a line on {@code err}, or the error that ends the command. */
  private Consumer<String> on(PrintWriter err) {
    return warning -> {
      if (strict) {
        throw new InputException(asError(warning));
      }
      err.println("warning: " + Place.printable(warning));
    };
  }

  /** Reads a scenario with what is asked for in its place, and warnings on {@code err}. */
  Scenario read(Path file, Settings asked, Catalogue catalogue, PrintWriter err) {
    Consumer<String> warned = on(err);
    Scenario scenario = ScenarioReader.read(file, catalogue.movements().names()::contains, warned);
    List<String> parts = scenario.networkParts();
    if (!parts.isEmpty()) {
      warned.accept(
          Texts.format(
              "%s: CamSim's network (%s) is kept but not simulated here; 'hificamsim camsim'"
                  + " does",
              file, String.join(", ", parts)));
    }
    return asked.scenario(scenario);
  }

  /** Reads several scenarios, each with a name of its own. */
  List<Scenario> read(List<Path> files, Settings asked, Catalogue catalogue, PrintWriter err) {
    List<Scenario> all = files.stream().map(file -> read(file, asked, catalogue, err)).toList();
    NameLists.requireDistinct("the scenarios' names", all.stream().map(Scenario::name).toList());
    return all;
  }

  /** Warns of what is odd about a scenario as a detection sees it. */
  void warnAbout(Path file, Scenario scenario, Detection used, PrintWriter err) {
    DetectionHints.of(scenario, used, Catalogue.load())
        .forEach(line -> on(err).accept(file + ": " + line));
  }
}
