package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.NamedSetting;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.OutputFolder;
import picocli.CommandLine.Model.CommandSpec;

/**
 * Writes the files of a scenario that a command makes from a plan, and the command's warnings.
 *
 * @param name the name of the scenario
 * @param picture the picture of the floor plan; empty if there is none
 */
record SiteOutput(CommandSpec command, String name, Optional<Path> picture) {
  /** The name of the scenario's file. */
  String scenarioFile() {
    return name + ".xml";
  }

  /** Checks before the work that the scenario and other files may be written into a folder. */
  void claim(Path folder, List<String> others) throws IOException {
    List<String> names = new ArrayList<>(List.of(scenarioFile()));
    names.addAll(others);
    picture.ifPresent(image -> names.add(PlanOptions.floorplanName(name, image)));
    Destination.claim(command, folder, names);
  }

  /** Writes the scenario, and a copy of the picture next to it. */
  void write(OutputFolder folder, String xml) throws IOException {
    if (picture.isPresent()) {
      folder.copy(PlanOptions.floorplanName(name, picture.get()), picture.get());
    }
    folder.write(scenarioFile(), xml);
  }

  /** Prints a warning, in which settings are written as options. */
  void warn(String warning) {
    command.commandLine().getErr().println("warning: " + printable(warning));
  }

  /** Escapes a line for the terminal, and writes its settings as options. */
  static String printable(String line) {
    return Place.printable(NamedSetting.written(line, Flags.NOTATION));
  }
}
