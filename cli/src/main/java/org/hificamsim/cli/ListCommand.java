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
  private static final String WHAT_THRESHOLDS_MEAN =
      """
threshold: a target is detected where the model's confidence reaches it (--threshold, NAME@T).
The defaults of the hi-fi models all lie where f puts the target at 3.2 % of the image: models
with one f then detect the same targets, whatever their detector.
chance: with --detect chance the detector counts, too. A target whose confidence is the second
number is detected half of the time, one that is not there 5 % of the time. See docs/detection.md.\
""";

  @Spec private CommandSpec spec;

  @Command(description = "Detection models, with their thresholds.")
  void detections() {
    Registry<DetectionModel> detections = Catalogue.load().detections();
    for (Registry.Entry<DetectionModel> entry : detections.entries()) {
      line(entry.name(), entry.summary() + thresholds(detections.create(entry.name())));
    }
    out().printf("%n%s%n", WHAT_THRESHOLDS_MEAN);
    out().flush();
  }

  /** The default threshold, and the one of {@code --detect chance} with its default options. */
  private static String thresholds(DetectionModel model) {
    double byChance = model.scatter().map(scatter -> scatter.threshold(0.05)).orElse(Double.NaN);
    return String.format(Locale.ROOT, " (threshold %.4g", model.defaultThreshold())
        + (Double.isNaN(byChance)
            ? ")"
            : String.format(Locale.ROOT, "; chance: half of the time at %.4g)", byChance));
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
