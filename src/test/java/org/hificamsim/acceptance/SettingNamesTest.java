package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Tests that messages name a setting as its user knows it; python/tests has the tests of Python.
 */
class SettingNamesTest {
  /** The only flags that libraries may contain, which are those of {@code git describe}. */
  private static final Pattern FLAG_OF_GIT =
      Pattern.compile("\"--(always|dirty|abbrev=40|exclude=\\*)\"");

  private static final Pattern LITERAL = Pattern.compile("\"(?:[^\"\\\\\\n]|\\\\.)*\"");
  private static final Pattern FLAG = Pattern.compile("--[a-z]");

  @TempDir private Path folder;

  /** Leaves out the command line, and the benchmarks, which have no main classes. */
  @ParameterizedTest
  @EnumSource(
      value = Module.class,
      names = {"CLI", "BENCH"},
      mode = EnumSource.Mode.EXCLUDE)
  void librariesNameNoFlags(Module module) throws IOException {
    Path sources = Cli.ROOT.resolve(module.folder).resolve("src/main/java");
    try (Stream<Path> files = Files.walk(sources)) {
      List<String> flags =
          files
              .filter(file -> file.toString().endsWith(".java"))
              .flatMap(file -> literals(file).map(literal -> file.getFileName() + ": " + literal))
              .filter(literal -> FLAG.matcher(literal).find())
              .filter(literal -> !FLAG_OF_GIT.matcher(literal).find())
              .toList();
      assertEquals(List.of(), flags);
    }
  }

  private static Stream<String> literals(Path file) {
    return LITERAL.matcher(Cli.text(file)).results().map(MatchResult::group);
  }

  @Test
  void runNamesFlagInErrors() {
    Cli run = Cli.run("run", Cli.scenario("ring-random"), "--steps", 0, "--out", folder);
    assertTrue(run.err().startsWith("error: --steps is 0, expected "), run.err());
  }

  @Test
  void embeddedRunNamesSettingPlainlyInErrors() {
    Catalogue catalogue = Catalogue.load();
    Path file = Cli.scenario("ring-random");
    Scenario scenario = ScenarioReader.read(file, catalogue.movements()::knows, warning -> {});
    InputException fault =
        assertThrows(
            InputException.class,
            () -> {
              Settings settings = Settings.NONE.with(Setting.STEPS, "0");
              new RunExecutor(catalogue)
                  .execute(
                      settings.plan(
                          scenario, DetectionSpec.of(settings, scenario, file, catalogue)),
                      run -> List.of());
            });
    assertEquals("steps is 0, expected a whole number from 1 to 1000000000", fault.getMessage());
  }

  @ParameterizedTest
  @EnumSource(Setting.class)
  void everySettingIsNamedInItsErrors(Setting setting) {
    EnumSet<Setting> acceptAnyText = EnumSet.of(Setting.DETECTION, Setting.POLICY, Setting.NETWORK);
    if (!acceptAnyText.contains(setting)) {
      InputException fault =
          assertThrows(InputException.class, () -> Settings.NONE.with(setting, "no such value"));
      assertTrue(fault.getMessage().contains(setting.label()), fault.getMessage());
    }
  }
}
