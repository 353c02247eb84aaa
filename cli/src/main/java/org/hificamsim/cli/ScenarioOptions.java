package org.hificamsim.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.scenario.Headings;
import org.hificamsim.core.scenario.NetworkParts;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.StepOrder;
import picocli.CommandLine.Option;

/** The options that override what a scenario file says. */
final class ScenarioOptions {
  @Option(
      names = "--order",
      paramLabel = "coverage|camsim",
      description = "Whether targets move after (coverage) or before (camsim) the observation.")
  private String order;

  @Option(
      names = "--headings",
      paramLabel = "degrees|as-radians",
      description = "How targets' headings are read; as-radians is the coverage study's way.")
  private String headings;

  /** Reads a scenario, telling warnings on {@code err}. */
  Scenario read(Path file, Catalogue catalogue, PrintWriter err) {
    StepOrder newOrder = choice(StepOrder.class, "--order", order);
    Headings newHeadings = choice(Headings.class, "--headings", headings);
    Scenario scenario =
        ScenarioReader.read(
            file,
            catalogue.movements().names()::contains,
            warning -> err.println("warning: " + Place.printable(warning)));
    warnAboutNetwork(file, scenario, err);
    if (newOrder != null) {
      scenario = scenario.withOrder(newOrder);
    }
    if (newHeadings != null) {
      scenario = scenario.withHeadings(newHeadings);
    }
    return scenario;
  }

  private static void warnAboutNetwork(Path file, Scenario scenario, PrintWriter err) {
    List<String> parts = NetworkParts.of(scenario);
    if (!parts.isEmpty()) {
      err.println(
          "warning: %s: CamSim's network (%s) is kept but not simulated here; 'hificamsim camsim' does"
              .formatted(file, String.join(", ", parts)));
    }
  }

  private static <E extends Enum<E>> E choice(Class<E> type, String option, String text) {
    if (text == null) {
      return null;
    }
    return Spelling.find(type, text)
        .orElseThrow(
            () ->
                new InputException(
                    option + " is '" + text + "', expected one of " + Spelling.all(type)));
  }
}
