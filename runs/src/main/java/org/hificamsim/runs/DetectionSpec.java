package org.hificamsim.runs;

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
 * A detection as users name it: {@code NAME} or {@code FILE.json}, or either with a threshold or a
 * rule of its own, {@code NAME@T}, {@code NAME@chance:alpha=0.01}.
 *
 * @param text as users name it
 * @param threshold the detection's own, in [0, 1]
 * @param rule the detection's own
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
   * Reads one.
   *
   * @param models finds a model by its name or file
   * @throws InputException when there is no such model, or its threshold or rule is wrong
   */
  public static DetectionSpec parse(String text, Function<String, DetectionModel> models) {
    Matcher parts = WITH_THRESHOLD.matcher(text);
    Matcher ruled = WITH_RULE.matcher(text);
    if (parts.matches()) {
      Optional<Double> own = Optional.of(Threshold.parse("threshold", parts.group(2)));
      return new DetectionSpec(text, models.apply(parts.group(1)), own, Optional.empty());
    }
    if (ruled.matches()) {
      String rule = text.substring(ruled.end(1) + 1).replace(';', ',');
      DetectionModel model = models.apply(ruled.group(1));
      return new DetectionSpec(
          text, model, Optional.empty(), Optional.of(DetectionRule.parse(rule)));
    }
    return new DetectionSpec(text, models.apply(text), Optional.empty(), Optional.empty());
  }

  /** The same by this rule unless it has one of its own. */
  public DetectionSpec or(DetectionRule other) {
    return new DetectionSpec(text, model, threshold, rule.or(() -> Optional.of(other)));
  }

  /**
   * The detection of a scenario: the one that is asked for, else the scenario's, else the default.
   *
   * @param file where the scenario was read, for errors
   * @throws InputException when there is no such model, or its threshold or rule is wrong
   */
  public static Detection of(Settings asked, Scenario scenario, Path file, Catalogue catalogue) {
    return parse(asked, scenario, file, catalogue).detection(asked, scenario);
  }

  private static DetectionSpec parse(
      Settings asked, Scenario scenario, Path file, Catalogue catalogue) {
    try {
      return parse(asked.value(Setting.DETECTION, scenario), catalogue::detection);
    } catch (InputException e) {
      throw asked.source(Setting.DETECTION, scenario) == SettingSource.SCENARIO
          ? ScenarioReader.error(file, Scenario.DETECTION, e)
          : e;
    }
  }

  /** The detection where no scenario has a say. */
  public Detection detection(Settings asked) {
    return detection(asked, OptionalDouble.empty(), Optional.empty());
  }

  /**
   * The detection with the first rule or threshold that there is: its own, the one that is asked
   * for, the scenario's, the default. A threshold asks for the rule of thresholds. That of a
   * scenario which names a detection is for that one alone.
   *
   * @throws InputException when both a threshold and a rule of chance are asked for
   */
  public Detection detection(Settings asked, Scenario scenario) {
    boolean another =
        scenario.find(Scenario.DETECTION).isPresent()
            && asked.source(Setting.DETECTION, scenario) == SettingSource.OPTION;
    return detection(
        asked, another ? OptionalDouble.empty() : scenario.threshold(), scenario.detect());
  }

  Detection detection(
      Settings asked, OptionalDouble ofScenario, Optional<DetectionRule> ruleOfScenario) {
    Optional<Double> asThreshold = asked.asked(Setting.THRESHOLD).map(Threshold::parse);
    DetectionRule first =
        rule(asThreshold, asked.asked(Setting.DETECT).map(DetectionRule::parse))
            .or(() -> ruleOfScenario)
            .orElseGet(DetectionRule.Threshold::new);
    if (!first.certain()) {
      return Detection.by(first, name(first), model);
    }
    double used =
        threshold
            .or(() -> asThreshold)
            .orElseGet(() -> ofScenario.orElse(model.defaultThreshold()));
    return new Detection(name(first), model, used);
  }

  /** The rule that the detection itself or, after it, the user asks for. */
  private Optional<DetectionRule> rule(
      Optional<Double> asThreshold, Optional<DetectionRule> askedRule) {
    if (rule.isPresent() || threshold.isPresent()) {
      return rule.or(() -> Optional.of(new DetectionRule.Threshold()));
    }
    if (asThreshold.isPresent() && askedRule.isPresent() && !askedRule.get().certain()) {
      throw InputException.of(
          "threshold is %s, expected none with detect=%s",
          asThreshold.get(), askedRule.get().text());
    }
    return askedRule.or(() -> asThreshold.map(value -> new DetectionRule.Threshold()));
  }

  /**
   * The name in result files: the model's with its own threshold or, unless that is by a threshold,
   * with the rule; {@link #parse} understands it.
   */
  private String name(DetectionRule used) {
    return used.certain()
        ? model.name() + threshold.map(value -> "@" + value).orElse("")
        : model.name() + "@" + used.text().replace(',', ';');
  }
}
