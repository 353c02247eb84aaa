package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.generate.RandomField;
import org.hificamsim.runs.generate.RandomSite;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim generate}: writes a random scenario of any size. */
@Command(
    name = "generate",
    description = "Generates a scenario with randomly placed cameras and targets.")
final class GenerateCommand implements Callable<Integer> {
  private static final int MAX_CAMERAS_OR_TARGETS = 200_000;
  private static final int MAX_WALLS = 10_000;
  private static final double MAX_AREA = 1e9;

  @Parameters(paramLabel = "SCENARIO.xml", description = "The file to write.")
  private Path file;

  @Option(names = "--cameras", paramLabel = "N")
  private int cameras;

  @Option(names = "--targets", paramLabel = "N")
  private Integer targets;

  @Option(names = "--area", paramLabel = "A")
  private Double area;

  @Option(names = "--lenses")
  private boolean lenses;

  @Option(names = "--walls", paramLabel = "N")
  private int walls;

  @Mixin private Destination destination;

  @Spec private CommandSpec spec;

  @Mixin private final SettingOptions settings = SettingOptions.of(Setting.SEED, Setting.OBJECTIVE);

  @Override
  public Integer call() throws IOException {
    RandomField field = field();
    Scenario scenario = settings.settings().scenario(scenario(field));
    Path absolute = file.toAbsolutePath();
    if (Files.isDirectory(absolute) || absolute.getFileName() == null) {
      throw new InputException("'" + file + "' is a folder, expected the name of a file");
    }
    OutputFile.inFolder("SCENARIO.xml", absolute, destination.force())
        .write(ScenarioWriter.write(scenario));
    spec.commandLine()
        .getOut()
        .printf("%s: %s cameras, %s targets%n", file, field.cameras(), field.targets());
    return 0;
  }

  private Scenario scenario(RandomField field) {
    if (walls != 0 && !lenses) {
      throw new InputException("--walls is given without --lenses, expected both");
    }
    Numbers.inRange("--walls", walls, 0, MAX_WALLS);
    return lenses ? new RandomSite(field, walls).scenario() : field.scenario();
  }

  private RandomField field() {
    Numbers.inRange("--cameras", cameras, 1, MAX_CAMERAS_OR_TARGETS);
    long seed = settings.settings().seed();
    RandomField defaults =
        lenses ? RandomSite.size(cameras, seed) : RandomField.ofCameras(cameras, seed);
    if (targets != null) {
      Numbers.inRange("--targets", targets, 1, MAX_CAMERAS_OR_TARGETS);
    }
    if (area != null && !(area > 0 && area <= MAX_AREA)) {
      throw InputException.of(
          "--area is %s, expected a number above 0 and at most %s", area, MAX_AREA);
    }
    return new RandomField(
        cameras,
        targets != null ? targets : defaults.targets(),
        area != null ? area : defaults.area(),
        seed);
  }
}
