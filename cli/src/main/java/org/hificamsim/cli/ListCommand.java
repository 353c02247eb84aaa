package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Locale;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.ScenarioReader;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code hificamsim list}: what can be asked for by name. */
@Command(name = "list", description = "Lists detection models, policies or scenarios.")
final class ListCommand {
  @Spec private CommandSpec spec;

  @Command(description = "Detection models, with their default threshold.")
  void detections() {
    for (Registry.Entry<DetectionModel> entry : Catalogue.load().detections().entries()) {
      DetectionModel model = Catalogue.load().detections().create(entry.name());
      line(
          entry.name(),
          entry.summary()
              + String.format(Locale.ROOT, " (threshold %.4g)", model.defaultThreshold()));
    }
  }

  @Command(description = "Zoom policies, with their options and defaults.")
  void policies() {
    Registry<ZoomPolicy> policies = Catalogue.load().policies();
    for (Registry.Entry<ZoomPolicy> entry : policies.entries()) {
      line(entry.name(), entry.summary());
      policies
          .options(entry.name())
          .forEach(
              option ->
                  out()
                      .printf(
                          "    %s=%s  %s%n",
                          option.key(), option.defaultValue(), option.meaning()));
    }
    out().flush();
  }

  @Command(description = "The scenarios that come with the simulator.")
  void scenarios() throws IOException {
    Catalogue catalogue = Catalogue.load();
    for (Path file : ShippedScenarios.files()) {
      line(
          file.toString(),
          Descriptions.of(
              ScenarioReader.read(file, catalogue.movements().names()::contains, warning -> {})));
    }
  }

  private void line(String name, String summary) {
    out().printf("%-28s %s%n", name, summary);
    out().flush();
  }

  private PrintWriter out() {
    return spec.commandLine().getOut();
  }
}
