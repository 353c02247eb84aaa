package org.hificamsim.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.scenario.Headings;
import org.hificamsim.core.scenario.NetworkParts;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.StepOrder;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Overrides;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options that override what a scenario file says. */
final class ScenarioOptions {
  @Mixin private DetectOptions detect;

  @Mixin private Warnings warnings;

  @Option(
      names = "--objective",
      paramLabel = Objective.CHOICES,
      description =
          "What a step is scored by, and optimal, one-hop and best-fixed maximise; before the"
              + " scenario's own. See docs/objectives.md.")
  private Optional<String> objective;

  @Option(
      names = "--order",
      paramLabel = "coverage|camsim",
      description = "Whether targets move after (coverage) or before (camsim) the observation.")
  private Optional<String> order;

  @Option(
      names = "--headings",
      paramLabel = "degrees|as-radians",
      description = "How targets' headings are read; as-radians is the coverage study's way.")
  private Optional<String> headings;

  /** Reads a scenario, with warnings on {@code err}. */
  Scenario read(Path file, Catalogue catalogue, PrintWriter err) {
    Overrides asked = overrides();
    Consumer<String> warned = warnings.on(err);
    Scenario scenario = ScenarioReader.read(file, catalogue.movements().names()::contains, warned);
    warnAboutNetwork(file, scenario, warned);
    return asked.scenario(scenario);
  }

  /** What a scenario is detected by. */
  Detection detection(DetectionSpec spec, Scenario scenario) {
    return overrides().detection(spec, scenario);
  }

  /**
   * Warns where the cameras' viewing angles and focal lengths contradict each other, or a model is
   * asked for what it was not fitted on.
   */
  void warnAboutLens(Path file, Scenario scenario, Detection detection, PrintWriter err) {
    Stream.of(DetectionHints.lens(scenario, detection), Extrapolation.warning(scenario, detection))
        .flatMap(Optional::stream)
        .forEach(line -> warnings.on(err).accept(file + ": " + line));
  }

  /** The rule of detection that was asked for. */
  Optional<DetectionRule> rule() {
    return overrides().rule();
  }

  /** The threshold that was asked for; null for none. */
  Double threshold() {
    return overrides().threshold().orElse(null);
  }

  private Overrides overrides() {
    return new Overrides(
        detect.threshold(),
        detect.rule(),
        objective.map(Objective::parse),
        order.map(text -> choice(StepOrder.class, "--order", text)),
        headings.map(text -> choice(Headings.class, "--headings", text)));
  }

  private static void warnAboutNetwork(Path file, Scenario scenario, Consumer<String> warned) {
    List<String> parts = NetworkParts.of(scenario);
    if (!parts.isEmpty()) {
      warned.accept(
          "%s: CamSim's network (%s) is kept but not simulated here; 'hificamsim camsim' does"
              .formatted(file, String.join(", ", parts)));
    }
  }

  /** The constant that an option names. */
  static <E extends Enum<E>> E choice(Class<E> type, String option, String text) {
    return Spelling.find(type, text)
        .orElseThrow(
            () ->
                new InputException(
                    option + " is '" + text + "', expected one of " + Spelling.all(type)));
  }
}
