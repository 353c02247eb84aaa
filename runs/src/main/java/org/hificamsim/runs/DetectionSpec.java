package org.hificamsim.runs;

import static org.hificamsim.core.NamedSetting.setting;

import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;

/**
 * A detection as users name it: {@code NAME} or {@code FILE.json}, optionally with a threshold or a
 * rule, as {@code NAME@T} or {@code NAME@chance:alpha=0.01}.
 *
 * @param text the name
 * @param threshold the threshold in the name, in [0, 1]
 * @param rule the rule in the name
 */
public record DetectionSpec(
    String text, DetectionModel model, Optional<Double> threshold, Optional<DetectionRule> rule) {
  private static final Pattern WITH_THRESHOLD = Pattern.compile("(.+)@([-+.\\deE]+)");
  private static final Pattern WITH_RULE =
      Pattern.compile("(.+)@(" + String.join("|", DetectionRule.rules().names()) + ")(:[^@]*)?");

  /** Checks the threshold. */
  public DetectionSpec {
    threshold.ifPresent(value -> Threshold.require("threshold", value));
  }

  /**
   * Reads a name.
   *
   * @param models finds a model by its name or file
   * @throws InputException when there is no such model, or its threshold or rule is wrong
   */
  public static DetectionSpec parse(String text, Function<String, DetectionModel> models) {
    Matcher withThreshold = WITH_THRESHOLD.matcher(text);
    Matcher withRule = WITH_RULE.matcher(text);
    if (withThreshold.matches()) {
      DetectionModel model = models.apply(withThreshold.group(1));
      double threshold = Threshold.parse("threshold", withThreshold.group(2));
      return new DetectionSpec(text, model, Optional.of(threshold), Optional.empty());
    }
    if (withRule.matches()) {
      String rule = text.substring(withRule.end(1) + 1).replace(';', ',');
      DetectionModel model = models.apply(withRule.group(1));
      return new DetectionSpec(
          text, model, Optional.empty(), Optional.of(DetectionRule.parse(rule)));
    }
    return new DetectionSpec(text, models.apply(text), Optional.empty(), Optional.empty());
  }

  /** Adds a rule to a name that has none. */
  public DetectionSpec or(DetectionRule other) {
    return new DetectionSpec(text, model, threshold, rule.or(() -> Optional.of(other)));
  }

  /**
   * The detection for a scenario: the one that is asked for, else the scenario's, else the default.
   *
   * @param file the file of the scenario, for errors
   * @throws InputException when there is no such model, or its threshold or rule is wrong
   */
  public static Detection of(Settings settings, Scenario scenario, Path file, Catalogue catalogue) {
    return parse(settings, scenario, file, catalogue).detection(settings, scenario);
  }

  private static DetectionSpec parse(
      Settings settings, Scenario scenario, Path file, Catalogue catalogue) {
    try {
      return parse(settings.value(Setting.DETECTION, scenario), catalogue::detection);
    } catch (InputException e) {
      throw settings.source(Setting.DETECTION, scenario) == SettingSource.SCENARIO
          ? ScenarioReader.error(file, Scenario.DETECTION, e)
          : e;
    }
  }

  /** Returns the detection that its name and the user's settings determine, without a scenario. */
  public Detection detection(Settings settings) {
    return detection(settings, OptionalDouble.empty(), Optional.empty());
  }

  /**
   * The detection with its rule and threshold, each from the first of these that has one: its name,
   * the user's settings, the scenario, the default. A threshold in the settings implies the rule of
   * thresholds. If a scenario names a detection, its threshold applies to that detection only.
   *
   * @throws InputException when both a threshold and a rule of chance are asked for
   */
  public Detection detection(Settings settings, Scenario scenario) {
    boolean replacesDetection =
        scenario.find(Scenario.DETECTION).isPresent()
            && settings.source(Setting.DETECTION, scenario) == SettingSource.OPTION;
    OptionalDouble threshold = replacesDetection ? OptionalDouble.empty() : scenario.threshold();
    return detection(settings, threshold, scenario.detect());
  }

  Detection detection(
      Settings settings,
      OptionalDouble thresholdOfScenario,
      Optional<DetectionRule> ruleOfScenario) {
    Optional<Double> askedThreshold = settings.asked(Setting.THRESHOLD).map(Threshold::parse);
    DetectionRule used =
        rule(askedThreshold, settings.asked(Setting.DETECT).map(DetectionRule::parse))
            .or(() -> ruleOfScenario)
            .orElseGet(model::defaultRule);
    if (!used.certain()) {
      return Detection.by(used, name(used), model);
    }
    double usedThreshold =
        threshold
            .or(() -> askedThreshold)
            .orElseGet(() -> thresholdOfScenario.orElse(model.defaultThreshold()));
    return new Detection(name(used), model, usedThreshold);
  }

  /** The rule in the name of the detection, else the one that the user asks for. */
  private Optional<DetectionRule> rule(
      Optional<Double> askedThreshold, Optional<DetectionRule> askedRule) {
    if (rule.isPresent() || threshold.isPresent()) {
      return rule.or(() -> Optional.of(new DetectionRule.Threshold()));
    }
    if (askedThreshold.isPresent() && askedRule.isPresent() && !askedRule.get().certain()) {
      throw InputException.of(
          "%s is %s, expected none with %s",
          setting("threshold"), askedThreshold.get(), setting("detect", askedRule.get().text()));
    }
    return askedRule.or(() -> askedThreshold.map(value -> new DetectionRule.Threshold()));
  }

  /**
   * The name in result files, which {@link #parse} can read: the name of the model, with the
   * threshold in this name or with a rule other than that of thresholds.
   */
  private String name(DetectionRule used) {
    return used.certain()
        ? model.name() + threshold.map(value -> "@" + value).orElse("")
        : model.name() + "@" + used.text().replace(',', ';');
  }
}
