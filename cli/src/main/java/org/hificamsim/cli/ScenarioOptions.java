package org.hificamsim.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Predicate;
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

/** Reads scenario files with the user's settings and {@code --strict}. */
final class ScenarioOptions {
  @Option(names = "--strict")
  private boolean strict;

  /** Whether warnings are errors. */
  boolean strict() {
    return strict;
  }

  /** The message of a warning that {@code --strict} makes an error. */
  static String asError(String warning) {
    return warning + "; expected no warning, with --strict";
  }

  /**
   * Returns a consumer that prints a warning on {@code err}, or throws it with {@code --strict}.
   */
  private Consumer<String> warningsTo(PrintWriter err) {
    return warning -> {
      if (strict) {
        throw new InputException(asError(warning));
      }
      err.println("warning: " + Place.printable(warning));
    };
  }

  /** Reads a scenario, applies the user's settings, and prints warnings on {@code err}. */
  Scenario read(Path file, Settings asked, Catalogue catalogue, PrintWriter err) {
    return read(ScenarioReader::read, file, asked, catalogue, err);
  }

  /** Reads a scenario like {@link #read}, but also accepts one without cameras or targets. */
  Scenario readSite(Path file, Settings asked, Catalogue catalogue, PrintWriter err) {
    return read(ScenarioReader::readSite, file, asked, catalogue, err);
  }

  /** A way to read a scenario file. */
  private interface Reading {
    Scenario read(Path file, Predicate<String> movements, Consumer<String> warnings);
  }

  private Scenario read(
      Reading reading, Path file, Settings asked, Catalogue catalogue, PrintWriter err) {
    Consumer<String> warnings = warningsTo(err);
    Scenario scenario = reading.read(file, catalogue.movements().names()::contains, warnings);
    List<String> parts = scenario.networkParts();
    if (!parts.isEmpty()) {
      warnings.accept(
          Texts.format(
              "%s: CamSim's network (%s) is kept but not simulated here; 'hificamsim camsim'"
                  + " does",
              file, String.join(", ", parts)));
    }
    return asked.scenario(scenario);
  }

  /** Reads several scenarios, which must have different names. */
  List<Scenario> read(List<Path> files, Settings asked, Catalogue catalogue, PrintWriter err) {
    List<Scenario> scenarios =
        files.stream().map(file -> read(file, asked, catalogue, err)).toList();
    NameLists.requireDistinct(
        "the scenarios' names", scenarios.stream().map(Scenario::name).toList());
    return scenarios;
  }

  /** Warns if a scenario and a detection do not suit each other. */
  void warnAbout(
      Path file, Scenario scenario, Detection used, Catalogue catalogue, PrintWriter err) {
    DetectionHints.of(scenario, used, catalogue)
        .forEach(line -> warningsTo(err).accept(file + ": " + line));
  }
}
