package org.hificamsim.python;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Function;
import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.scenario.Headings;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.StepOrder;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Overrides;
import org.hificamsim.worlds.ActionKind;
import org.hificamsim.worlds.Rewards;
import org.hificamsim.worlds.WorldSettings;

/**
 * What Python asks for, as JSON. What is null is left to the scenario, or to the default.
 *
 * @param scenario a file
 * @param worlds how many
 * @param threads that share them
 * @param steps of an episode
 * @param seed of the first world
 * @param actions view or steps
 * @param targets that an observation has room for
 * @param neighbours that an observation has room for
 * @param paints whether pictures of the first world will be asked for
 */
record Request(
    String scenario,
    String detection,
    Double threshold,
    String detect,
    String objective,
    String order,
    String headings,
    int worlds,
    int threads,
    int steps,
    long seed,
    String reward,
    String actions,
    int targets,
    int neighbours,
    boolean autoReset,
    boolean paints) {
  static Request parse(String json) {
    try {
      return new ObjectMapper().readValue(json, Request.class);
    } catch (JsonProcessingException e) {
      throw new InputException("settings: " + e.getOriginalMessage(), e);
    }
  }

  /** Reads the scenario, and finds everything by its name. */
  WorldSettings worldSettings(Catalogue catalogue) {
    Overrides overrides = overrides();
    DetectionSpec spec = DetectionSpec.parse(detection, catalogue::detection);
    Scenario read =
        overrides.scenario(
            ScenarioReader.read(Path.of(scenario), catalogue.movements()::knows, warning -> {}));
    Detection used = overrides.detection(spec, read);
    Rewards.registry().create(reward); // a wrong one is refused here
    return new WorldSettings(
        read,
        catalogue.movements(),
        used,
        new ObservationLayout(targets, neighbours),
        choice(ActionKind.class, "actions", actions),
        () -> Rewards.registry().create(reward),
        steps,
        autoReset);
  }

  private Overrides overrides() {
    return new Overrides(
        Optional.ofNullable(threshold),
        given(detect, DetectionRule::parse),
        given(objective, Objective::parse),
        given(order, text -> choice(StepOrder.class, "order", text)),
        given(headings, text -> choice(Headings.class, "headings", text)));
  }

  private static <T> Optional<T> given(String text, Function<String, T> parse) {
    return Optional.ofNullable(text).map(parse);
  }

  private static <E extends Enum<E>> E choice(Class<E> type, String setting, String text) {
    return Spelling.find(type, text)
        .orElseThrow(
            () ->
                new InputException(
                    setting + " is '" + text + "', expected one of " + Spelling.all(type)));
  }
}
