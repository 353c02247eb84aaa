package org.hificamsim.core;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;

/**
 * A command line of CamSim with recorded results.
 *
 * @param scenario the name of the file in the {@link Reference}
 * @param options the words before the file
 */
public record CamSimCommand(String scenario, List<String> options) {
  public static CamSimCommand of(String scenario, String options) {
    return new CamSimCommand(scenario, List.of(options.strip().split("\\s+")));
  }

  public int steps() {
    return number("-t").orElseThrow();
  }

  public long seed() {
    return number("-s").orElse(0);
  }

  /** Returns the word after an option, if the option is given. */
  public Optional<String> option(String name) {
    int index = options.indexOf(name);
    return index < 0 ? Optional.empty() : Optional.of(options.get(index + 1));
  }

  /** Returns the whole number after an option, if the option is given. */
  public Optional<Integer> number(String name) {
    return option(name).map(Integer::valueOf);
  }

  /** Reads the scenario, with the movement that the options name. */
  public Scenario read() {
    Scenario read =
        ScenarioReader.read(Reference.file(scenario), anyMovement -> true, new ArrayList<>()::add);
    return option("-m").map(read::withMovement).orElse(read);
  }
}
