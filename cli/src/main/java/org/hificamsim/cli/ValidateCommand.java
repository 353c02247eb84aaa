package org.hificamsim.cli;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.presentation.replay.FloorPictures;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim validate}: reads scenario files and reports all that is wrong or odd. */
@Command(
    name = "validate",
    description =
        "Checks scenario files; prints errors (exit code 2) and warnings with line and column.")
final class ValidateCommand implements Callable<Integer> {
  @Parameters(arity = "1..*", paramLabel = "SCENARIO.xml", description = "The scenario files.")
  private List<Path> files;

  @Mixin private ScenarioOptions scenarioOptions;

  @Mixin private final SettingOptions settings = SettingOptions.of(Setting.DETECTION);

  @Option(names = "--json")
  private boolean json;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() {
    Catalogue catalogue = Catalogue.load();
    Settings asked = settings.settings();
    asked
        .asked(Setting.DETECTION)
        .ifPresent(name -> DetectionSpec.parse(name, catalogue::detection));
    List<Checked> all = new ArrayList<>();
    for (Path file : files) {
      Checked one = check(file, asked, catalogue);
      all.add(scenarioOptions.strict() ? one.strict() : one);
      tell(all.get(all.size() - 1));
    }
    if (json) {
      print(all.stream().map(Checked::entry).toList());
    }
    return all.stream().allMatch(Checked::valid) ? 0 : Main.BAD_INPUT;
  }

  private void tell(Checked one) {
    one.print(json ? new PrintWriter(Writer.nullWriter()) : out(), spec.commandLine().getErr());
  }

  private static Checked check(Path file, Settings asked, Catalogue catalogue) {
    List<String> warned = new ArrayList<>();
    List<String> errors = new ArrayList<>();
    Optional<Scenario> scenario =
        ScenarioReader.check(
            file,
            catalogue.movements().names()::contains,
            NetworkSettings.DEFAULT.check(),
            warned::add,
            fault -> errors.add(fault.getMessage()));
    scenario.ifPresent(
        one -> {
          try {
            Detection used = DetectionSpec.of(asked, one, file, catalogue);
            DetectionHints.all(one, used, catalogue)
                .forEach(line -> warned.add(file + ": " + line));
          } catch (InputException e) {
            errors.add(e.getMessage());
          }
        });
    scenario.ifPresent(one -> warnAboutFloorplan(file, one, warned));
    return new Checked(file, scenario, errors, warned);
  }

  /** A run needs no floorplan, unless it is recorded. */
  private static void warnAboutFloorplan(Path file, Scenario scenario, List<String> warned) {
    try {
      FloorPictures.of(file, scenario);
    } catch (InputException e) {
      warned.add(e.getMessage());
    }
  }

  private void print(List<Checked.Entry> all) {
    DefaultIndenter lines = new DefaultIndenter("  ", "\n");
    DefaultPrettyPrinter printer =
        new DefaultPrettyPrinter().withObjectIndenter(lines).withArrayIndenter(lines);
    try {
      out().print(new ObjectMapper().writer(printer).writeValueAsString(all) + "\n");
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("records and lists have a form in JSON", e);
    }
    out().flush();
  }

  private PrintWriter out() {
    return spec.commandLine().getOut();
  }
}
