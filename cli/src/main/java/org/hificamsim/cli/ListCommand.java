package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Texts;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.hifi.FittedDetection;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code hificamsim list}: lists everything that has a name. */
@Command(name = "list", description = "Lists detection models, policies or scenarios.")
final class ListCommand {
  private static final String EXPLANATION_OF_THRESHOLDS =
      """
g(p): the model's confidence of a target that f puts at the share p of the image.
threshold: a target is detected where the confidence reaches it (--threshold, NAME@T). That of
hifi:orb-lin, 0.0441, was fitted to the thesis's Table 8.1; all other hi-fi and lab models take
what they give at the same share, 3.2 % of the image. Models with one f then detect the same
targets, whatever their detector, and by their own scatter 33 to 45 % of pictures without a target
would count as detections.
chance: with --detect chance the detector counts, too. A target whose confidence is the second
number is detected half of the time, one that fills nothing of the image never.
See docs/detection.md.
""";

  private static final DetectionRule BY_CHANCE = DetectionRule.parse("chance");

  @Spec private CommandSpec spec;

  @Command(description = "Detection models, with their thresholds.")
  void detections() {
    Registry<DetectionModel> models = Catalogue.load().detections();
    for (Registry.Entry<DetectionModel> entry : models.entries()) {
      line(entry.name(), entry.summary() + thresholds(models.create(entry.name())));
    }
    out().printf("%n%s", EXPLANATION_OF_THRESHOLDS);
    out().flush();
  }

  /**
   * Describes the equation of a fitted model and its thresholds. The second threshold, if there is
   * one, is the confidence at which the model detects half of the time by chance.
   */
  private static String thresholds(DetectionModel model) {
    String equation = model instanceof FittedDetection fitted ? "; " + fitted.equation() : "";
    String chance =
        model.scatter().isPresent()
            ? Texts.format(
                "; chance %.4g", Detection.by(BY_CHANCE, model.name(), model).threshold())
            : "";
    return equation + Texts.format(" (threshold %.4g%s)", model.defaultThreshold(), chance);
  }

  @Command(
      description =
          "Zoom policies, with their options and defaults. A bound knows what no camera can know.")
  void policies() {
    Catalogue catalogue = Catalogue.load();
    Registry<ZoomPolicy> policies = catalogue.policies();
    for (Registry.Entry<ZoomPolicy> policy : policies.entries()) {
      String kind = catalogue.isBound(policy.name()) ? "bound: " : "";
      line(policy.name(), kind + policy.summary());
      for (Options.Declared option : policies.options(policy.name())) {
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
