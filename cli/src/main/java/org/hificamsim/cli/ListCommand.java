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
  @Option(names = "--json", scope = ScopeType.INHERIT, description = "Print the list as JSON.")
  private boolean json;

  @Spec private CommandSpec spec;

  private record NamedDetection(String name, String summary, double threshold) {}

  private record NamedPolicy(String name, String summary, List<Options.Declared> options) {}

  private record ShippedScenario(String file, String summary) {}

  @Command(description = "Detection models, with their default threshold.")
  void detections() {
    Registry<DetectionModel> models = Catalogue.load().detections();
    print(
        models.entries().stream().map(entry -> detection(entry, models)).toList(),
        one ->
            line(
                one.name(),
                one.summary() + String.format(Locale.ROOT, " (threshold %.4g)", one.threshold())));
  }

  private static NamedDetection detection(
      Registry.Entry<DetectionModel> entry, Registry<DetectionModel> models) {
    double threshold = models.create(entry.name()).defaultThreshold();
    return new NamedDetection(entry.name(), entry.summary(), threshold);
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
