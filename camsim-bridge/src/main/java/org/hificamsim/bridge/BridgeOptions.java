package org.hificamsim.bridge;

import static org.hificamsim.bridge.NumberOption.number;
import static org.hificamsim.bridge.NumberOption.requireFor;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hificamsim.bridge.run.BridgeSettings;
import org.hificamsim.bridge.run.Tracks;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.AimingZoomPolicy;
import org.hificamsim.core.policy.HindsightZoomPolicy;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;

/** Reads the text after {@code -javaagent:hificamsim-bridge.jar=}. */
final class BridgeOptions {
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
    OpticsOptions optics = new OpticsOptions(given);
    Optional<String> objective = text("objective", "what a step is scored by");
    Optional<String> seed = text("seed", "seed of the policy, and of luck");
    Optional<String> tracks = text("tracks", "scenario whose tracks objects follow");
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
        optics.optics(policy.isPresent(), zooms),
        objective.map(Objective::parse).orElseGet(Objective::kMin),
        seed.map(BridgeOptions::seed).orElse(0),
        tracks.map(BridgeOptions::tracks),
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
    Settings asked = Settings.NONE;
    if (threshold.isPresent()) {
      number("threshold", threshold.get(), 0, 1);
      asked = asked.with(Setting.THRESHOLD, threshold.get());
    }
    if (detect.isPresent()) {
      asked = asked.with(Setting.DETECT, detect.get().replace(';', ','));
    }
    return DetectionSpec.parse(name, catalogue::detection).detection(asked);
  }

  private static Tracks tracks(String scenario) {
    Tracks tracks = Tracks.of(ScenarioReader.read(Path.of(scenario), name -> true, warning -> {}));
    if (tracks.isEmpty()) {
      throw new InputException(
          "tracks is '" + scenario + "', which has none, expected a scenario with <tracks>");
    }
    return tracks;
  }

  /** Commas separate the agent's own options: a policy's are separated by semicolons. */
  private BridgeSettings.Policy policy(String given) {
    String spec = given.replace(';', ',');
    ZoomPolicy made = catalogue.policies().create(spec);
    if (made instanceof HindsightZoomPolicy) {
      throw new InputException(
          "policy '"
              + spec
              + "' has to see the run before it begins, expected one that learns"
              + " or decides as the run goes");
    }
    if (made instanceof AimingZoomPolicy) {
      throw new InputException(
          "policy '"
              + spec
              + "' turns cameras to any angle, expected one that chooses among views");
    }
    return new BridgeSettings.Policy(spec, () -> catalogue.policies().create(spec));
  }

  private static List<Double> radii(String text) {
    return NumberOption.rising("zooms", text, Double.MIN_VALUE, MAX_METRES, "radii", "2.5;5;7.5");
  }

  private static int seed(String text) {
    return NumberOption.integer("seed", text, Integer.MIN_VALUE, Integer.MAX_VALUE);
  }

  /** The words of {@code strict}. */
  private enum Strict {
    FALSE,
    TRUE
  }
}
