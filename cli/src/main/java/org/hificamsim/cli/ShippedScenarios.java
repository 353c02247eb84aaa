package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.runs.benchmark.Benchmark;

/** The scenarios that come with the simulator: the folder {@code scenarios} of the project. */
final class ShippedScenarios {
  /** The project's folder as the launcher gives it, or else the working directory. */
  private static final Path HOME = Path.of(System.getProperty("hificamsim.root", ""));

  private ShippedScenarios() {}

  /** The files, by name. */
  static List<Path> files() throws IOException {
    try (Stream<Path> files = Files.list(folder())) {
      return files.filter(file -> file.toString().endsWith(".xml")).sorted().toList();
    }
  }

  /** Reads scenarios by name. */
  static Map<String, Scenario> read(List<String> names, Catalogue catalogue) {
    Path folder = folder();
    Map<String, Scenario> scenarios = new LinkedHashMap<>();
    for (String name : names) {
      scenarios.put(
          name,
          ScenarioReader.read(
              folder.resolve(name + ".xml"), catalogue.movements()::knows, warning -> {}));
    }
    return scenarios;
  }

  /** The tasks of the benchmark. */
  static Benchmark tasks() {
    return Benchmark.read(folder().resolve(Benchmark.FILE), Catalogue.load());
  }

  private static Path folder() {
    Path folder = HOME.resolve("scenarios");
    if (!Files.isDirectory(folder)) {
      throw new InputException("no folder '" + folder + "', expected to run in the project");
    }
    return folder;
  }
}
