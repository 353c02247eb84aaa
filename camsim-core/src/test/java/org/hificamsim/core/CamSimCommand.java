package org.hificamsim.core;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;

/**
 * A command line of CamSim's whose results were recorded.
 *
 * @param scenario the file's name in the {@link Reference}
 * @param options what stands before the file
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

  /** What follows this option, if it is there. */
  public Optional<String> option(String name) {
    int place = options.indexOf(name);
    return place < 0 ? Optional.empty() : Optional.of(options.get(place + 1));
  }

  /** Likewise, a whole number. */
  public Optional<Integer> number(String name) {
    return option(name).map(Integer::valueOf);
  }

  /** Its scenario, under the movement that it asks for. */
  public Scenario read() {
    Scenario read =
        ScenarioReader.read(Reference.file(scenario), anyMovement -> true, new ArrayList<>()::add);
    return option("-m").map(read::withMovement).orElse(read);
  }
}
