package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.ScenarioReader;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/** {@code hificamsim list}: what can be asked for by name. */
@Command(name = "list", description = "Lists detection models, policies or scenarios.")
final class ListCommand {
  private static final String WHAT_THRESHOLDS_MEAN =
      """
threshold: a target is detected where the model's confidence reaches it (--threshold, NAME@T).
The defaults of the hi-fi models all lie where f puts the target at 3.2 % of the image: models
with one f then detect the same targets, whatever their detector.
chance: with --detect chance the detector counts, too. A target whose confidence is the second
number is detected half of the time, one that fills nothing of the image 5 % of the time. See docs/detection.md.
""";

  private static final double FALSE_ALARMS = 0.05; // the default of --detect chance

  @Option(names = "--json", scope = ScopeType.INHERIT, description = "Print the list as JSON.")
  private boolean json;

  @Spec private CommandSpec spec;

  /** A model; by chance it detects half of the time at the second threshold, where it has one. */
  private record NamedDetection(
      String name, String summary, double threshold, Double chanceThreshold) {}

  private record NamedPolicy(String name, String summary, List<Options.Declared> options) {}

  private record ShippedScenario(String file, String summary) {}

  @Command(description = "Detection models, with their thresholds.")
  void detections() {
    Registry<DetectionModel> models = Catalogue.load().detections();
    print(
        models.entries().stream().map(entry -> detection(entry, models)).toList(),
        one -> line(one.name(), one.summary() + thresholds(one)));
    if (!json) {
      out().printf("%n%s", WHAT_THRESHOLDS_MEAN);
      out().flush();
    }
  }

  private static NamedDetection detection(
      Registry.Entry<DetectionModel> entry, Registry<DetectionModel> models) {
    DetectionModel model = models.create(entry.name());
    return new NamedDetection(
        entry.name(),
        entry.summary(),
        model.defaultThreshold(),
        model.scatter().map(scatter -> scatter.threshold(FALSE_ALARMS)).orElse(null));
  }

  private static String thresholds(NamedDetection one) {
    return String.format(Locale.ROOT, " (threshold %.4g", one.threshold())
        + (one.chanceThreshold() == null
            ? ")"
            : String.format(Locale.ROOT, "; chance %.4g)", one.chanceThreshold()));
  }

  @Command(description = "Zoom policies, with their options and defaults.")
  void policies() {
    Registry<ZoomPolicy> policies = Catalogue.load().policies();
    print(
        policies.entries().stream()
            .map(one -> new NamedPolicy(one.name(), one.summary(), policies.options(one.name())))
            .toList(),
        this::policy);
  }

  private void policy(NamedPolicy policy) {
    line(policy.name(), policy.summary());
    policy
        .options()
        .forEach(
            option ->
                out()
                    .printf(
                        "    %s=%s  %s%n", option.key(), option.defaultValue(), option.meaning()));
  }

  @Command(description = "The scenarios that come with the simulator.")
  void scenarios() throws IOException {
    Catalogue catalogue = Catalogue.load();
    List<ShippedScenario> scenarios = new ArrayList<>();
    for (Path file : ShippedScenarios.files()) {
      scenarios.add(
          new ShippedScenario(
              file.toString(),
              Descriptions.of(
                  ScenarioReader.read(file, catalogue.movements()::knows, warning -> {}))));
    }
    print(scenarios, one -> line(one.file(), one.summary()));
  }

  private <T> void print(List<T> items, Consumer<T> asText) {
    if (json) {
      Json.print(out(), items);
    } else {
      items.forEach(asText);
    }
    out().flush();
  }

  private void line(String name, String summary) {
    out().printf("%-28s %s%n", name, summary);
  }

  private PrintWriter out() {
    return spec.commandLine().getOut();
  }
}
