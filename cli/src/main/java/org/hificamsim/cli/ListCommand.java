package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Locale;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
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

  @Spec private CommandSpec spec;

  @Command(description = "Detection models, with their thresholds.")
  void detections() {
    Registry<DetectionModel> models = Catalogue.load().detections();
    for (Registry.Entry<DetectionModel> one : models.entries()) {
      line(one.name(), one.summary() + thresholds(models.create(one.name())));
    }
    out().printf("%n%s", WHAT_THRESHOLDS_MEAN);
    out().flush();
  }

  /** By chance, a model detects half of the time at the second threshold, where it has one. */
  private static String thresholds(DetectionModel model) {
    String chance =
        model
            .scatter()
            .map(one -> String.format(Locale.ROOT, "; chance %.4g", one.threshold(FALSE_ALARMS)))
            .orElse("");
    return String.format(Locale.ROOT, " (threshold %.4g%s)", model.defaultThreshold(), chance);
  }

  @Command(description = "Zoom policies, with their options and defaults.")
  void policies() {
    Registry<ZoomPolicy> policies = Catalogue.load().policies();
    for (Registry.Entry<ZoomPolicy> one : policies.entries()) {
      line(one.name(), one.summary());
      for (Options.Declared option : policies.options(one.name())) {
        out().printf("    %s=%s  %s%n", option.key(), option.defaultValue(), option.meaning());
      }
    }
    out().flush();
  }

  @Command(description = "The scenarios that come with the simulator.")
  void scenarios() throws IOException {
    Catalogue catalogue = Catalogue.load();
    for (Path file : ShippedScenarios.files()) {
      Scenario scenario = ScenarioReader.read(file, catalogue.movements()::knows, warning -> {});
      line(file.toString(), Descriptions.of(scenario));
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
