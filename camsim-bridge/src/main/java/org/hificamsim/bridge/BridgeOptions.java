package org.hificamsim.bridge;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hificamsim.bridge.run.BridgeSettings;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.HindsightZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Overrides;

/** Reads the text after {@code -javaagent:hificamsim-bridge.jar=}. */
final class BridgeOptions {
  private static final int MAX_LEVELS = 1000;
  private static final double MAX_METRES = 1e6;

  private final Catalogue catalogue;
  private final Options given;

  private BridgeOptions(String text, Catalogue catalogue) {
    this.catalogue = catalogue;
    this.given = Options.parse("options", text);
  }

  /**
   * The settings that {@code text} asks for.
   *
   * @throws InputException naming the option that is unknown, malformed or without effect
   */
  static BridgeSettings parse(String text, Catalogue catalogue) {
    return new BridgeOptions(text, catalogue).settings();
  }

  private BridgeSettings settings() {
    Optional<String> model = text("detection", "name or file of the detection model");
    Optional<String> threshold = text("threshold", "what counts as detected, 0 to 1");
    Optional<String> detect = text("detect", "how a confidence becomes a detection");
    Optional<String> size = text("size", "target size, m");
    Optional<String> policy = text("policy", "name and options of the zoom policy");
    Optional<String> zooms = text("zooms", "radii, m");
    Optional<String> objective = text("objective", "what a step is scored by");
    Optional<String> seed = text("seed", "seed of the policy, and of luck");
    Optional<String> out = text("out", "folder for result files");
    given.choice("strict", Strict.FALSE, "whether to stop when something is wrong");
    rejectUnknown();
    requireFor("threshold", threshold, model.isPresent(), "detection");
    requireFor("detect", detect, model.isPresent(), "detection");
    requireFor("size", size, model.isPresent(), "detection");
    Optional<Detection> used = model.map(name -> detection(name, threshold, detect));
    boolean draws = policy.isPresent() || used.filter(one -> !one.certain()).isPresent();
    requireFor("seed", seed, draws, "policy or detect");
    requireFor("objective", objective, policy.isPresent() || out.isPresent(), "policy or out");
    requireFor("zooms", zooms, model.isPresent() || policy.isPresent(), "policy or detection");
    return new BridgeSettings(
        used,
        size.map(value -> number("size", value, Double.MIN_VALUE, MAX_METRES))
            .orElse(TargetSpec.DEFAULT_SIZE),
        policy.map(this::policy),
        zooms.map(BridgeOptions::radii).orElse(List.of()),
        objective.map(Objective::parse).orElseGet(Objective::kMin),
        seed.map(BridgeOptions::seed).orElse(0),
        out.map(Path::of));
  }

  private Optional<String> text(String key, String meaning) {
    return Optional.ofNullable(given.text(key, null, meaning));
  }

  /** After a comma, what was meant for a policy is an unknown option here. */
  private void rejectUnknown() {
    try {
      given.rejectUnknown();
    } catch (InputException e) {
      throw new InputException(e.getMessage() + ", with ';' between a policy's own", e);
    }
  }

  private Detection detection(String name, Optional<String> threshold, Optional<String> detect) {
    return Overrides.ofDetection(
            threshold.map(value -> number("threshold", value, 0, 1)),
            detect.map(rule -> DetectionRule.parse(rule.replace(';', ','))))
        .detection(DetectionSpec.parse(name, catalogue::detection));
  }

  /** Commas separate the agent's own options: a policy's are separated by semicolons. */
  private BridgeSettings.Policy policy(String given) {
    String spec = given.replace(';', ',');
    if (catalogue.policies().create(spec) instanceof HindsightZoomPolicy) {
      throw new InputException(
          "policy '"
              + spec
              + "' has to see the run before it begins, expected one that learns"
              + " or decides as the run goes");
    }
    return new BridgeSettings.Policy(spec, () -> catalogue.policies().create(spec));
  }

  private static List<Double> radii(String text) {
    List<Double> radii = new ArrayList<>();
    for (String item : text.strip().split("[;,\\s]+")) {
      double radius = number("zooms", item, Double.MIN_VALUE, MAX_METRES);
      if (!radii.isEmpty() && radius <= radii.get(radii.size() - 1)) {
        throw new InputException(
            "zooms has '"
                + item
                + "' after "
                + radii.get(radii.size() - 1)
                + ", expected rising radii, each once, such as 2.5;5;7.5");
      }
      radii.add(radius);
    }
    if (radii.size() > MAX_LEVELS) {
      throw new InputException(
          "zooms has " + radii.size() + " radii, expected at most " + MAX_LEVELS);
    }
    return radii;
  }

  private static int seed(String text) {
    return Options.parse("options", "seed=" + text)
        .integer("seed", 0, Integer.MIN_VALUE, Integer.MAX_VALUE, "seed");
  }

  private static double number(String key, String text, double least, double most) {
    return Options.parse("options", key + "=" + text).number(key, least, least, most, key);
  }

  private static void requireFor(
      String key, Optional<String> value, boolean present, String needed) {
    if (value.isPresent() && !present) {
      throw new InputException(
          key + " is '" + value.get() + "' without " + needed + ", expected both");
    }
  }

  /** The words of {@code strict}. */
  private enum Strict {
    FALSE,
    TRUE
  }
}
