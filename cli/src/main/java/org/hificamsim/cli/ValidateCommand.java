package org.hificamsim.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.network.NetworkSettings;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim validate}: reads scenario files and tells all that is wrong or odd. */
@Command(
    name = "validate",
    description = "Checks scenario files: errors (exit code 2) and warnings, with their place.")
final class ValidateCommand implements Callable<Integer> {
  @Parameters(arity = "1..*", paramLabel = "SCENARIO.xml", description = "The scenario files.")
  private List<Path> files;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() {
    Catalogue catalogue = Catalogue.load();
    int exit = 0;
    for (Path file : files) {
      exit = Math.max(exit, validate(file, catalogue));
    }
    return exit;
  }

  private int validate(Path file, Catalogue catalogue) {
    PrintWriter out = spec.commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    try {
      Scenario scenario =
          ScenarioReader.read(
              file,
              catalogue.movements().names()::contains,
              NetworkSettings.DEFAULT.check(),
              line -> err.println("warning: " + Place.printable(line)));
      out.println(file + ": ok, " + Descriptions.of(scenario));
      return 0;
    } catch (InputException e) {
      err.println("error: " + Place.printable(e.getMessage()));
      return Main.BAD_INPUT;
    }
  }
}
