package org.hificamsim.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.presentation.replay.FloorPictures;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.hints.DetectionHints;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim validate}: reports all errors and warnings of scenario files. */
@Command(
    name = "validate",
    description =
        "Checks scenario files; prints errors (exit code 2) and warnings with line and column.")
final class ValidateCommand implements Callable<Integer> {
  /** The most errors, and the most warnings, that are printed for a file. */
  private static final int MAX_LINES = 100;

  @Parameters(arity = "1..*", paramLabel = "SCENARIO.xml", description = "The scenario files.")
  private List<Path> files;

  @Mixin private ScenarioOptions scenarioOptions;

  @Mixin private final SettingOptions settings = SettingOptions.of(Setting.DETECTION);

  @Spec private CommandSpec spec;

  @Override
  public Integer call() {
    Catalogue catalogue = Catalogue.load();
    Settings asked = settings.settings();
    asked
        .asked(Setting.DETECTION)
        .ifPresent(name -> DetectionSpec.parse(name, catalogue::detection));
    long invalid = files.stream().filter(file -> !isValid(file, asked, catalogue)).count();
    return invalid == 0 ? 0 : Main.BAD_INPUT;
  }

  /** Prints the errors and warnings of a file, or that it has no error. */
  private boolean isValid(Path file, Settings asked, Catalogue catalogue) {
    List<String> warnings = new ArrayList<>();
    List<String> errors = new ArrayList<>();
    Optional<Scenario> scenario =
        ScenarioReader.check(
            file,
            catalogue.movements().names()::contains,
            NetworkSettings.DEFAULT.check(),
            warnings::add,
            fault -> errors.add(fault.message(Flags.NOTATION)));
    scenario.ifPresent(read -> warnAbout(file, read, asked, catalogue, warnings, errors));
    if (scenarioOptions.strict()) {
      errors.addAll(0, warnings.stream().map(ScenarioOptions::asError).toList());
      warnings.clear();
    }
    print(file, "warning: ", warnings);
    print(file, "error: ", errors);
    if (errors.isEmpty()) {
      String description = Descriptions.of(scenario.orElseThrow());
      spec.commandLine().getOut().println(file + ": ok, " + description);
    }
    return errors.isEmpty();
  }

  private static void warnAbout(
      Path file,
      Scenario scenario,
      Settings asked,
      Catalogue catalogue,
      List<String> warnings,
      List<String> errors) {
    try {
      Detection used = DetectionSpec.of(asked, scenario, file, catalogue);
      DetectionHints.of(scenario, used, catalogue)
          .forEach(line -> warnings.add(file + ": " + line));
    } catch (InputException e) {
      errors.add(e.message(Flags.NOTATION));
    }
    for (Zone zone : scenario.zones()) {
      requireDetection(file, zone, catalogue, errors);
    }
    try {
      FloorPictures.of(file, scenario); // a recorded run needs the picture
    } catch (InputException e) {
      warnings.add(e.message(Flags.NOTATION));
    }
  }

  private static void requireDetection(
      Path file, Zone zone, Catalogue catalogue, List<String> errors) {
    try {
      if (zone.detection() != null) {
        DetectionSpec.parse(zone.detection(), catalogue::detection);
      }
    } catch (InputException e) {
      errors.add(file + ": zone '" + zone.name() + "': " + e.message(Flags.NOTATION));
    }
  }

  private void print(Path file, String prefix, List<String> lines) {
    PrintWriter err = spec.commandLine().getErr();
    lines.stream().limit(MAX_LINES).forEach(line -> err.println(prefix + Place.printable(line)));
    if (lines.size() > MAX_LINES) {
      err.println(prefix + file + ": " + (lines.size() - MAX_LINES) + " more, expected none");
    }
  }
}
