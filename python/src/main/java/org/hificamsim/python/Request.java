package org.hificamsim.python;

import static org.hificamsim.core.NamedSetting.setting;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.PropertyNamingStrategies;
import com.fasterxml.jackson.databind.cfg.CoercionAction;
import com.fasterxml.jackson.databind.cfg.CoercionInputShape;
import com.fasterxml.jackson.databind.exc.MismatchedInputException;
import com.fasterxml.jackson.databind.exc.UnrecognizedPropertyException;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.type.LogicalType;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.policy.HindsightZoomPolicy;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.benchmark.Benchmark;
import org.hificamsim.worlds.ActionKind;
import org.hificamsim.worlds.Rewards;
import org.hificamsim.worlds.WorldSettings;
import org.hificamsim.worlds.WorldSettings.AutoReset;

/**
 * A request of Python, parsed from JSON.
 *
 * @param settings the settings of a run
 * @param environment the settings that only environments have
 */
record Request(Settings settings, Environment environment) {
  /**
   * The settings of a run that environments have. Actions replace the policy, and episodes replace
   * repeats. Settings without an effect on episodes must be excluded here.
   */
  static final Set<Setting> SETTINGS =
      EnumSet.complementOf(
          EnumSet.of(Setting.POLICY, Setting.REPEAT, Setting.FOLLOWING, Setting.NETWORK));

  /** The settings that the Python package sets from its own arguments. */
  private static final Set<String> ARGUMENTS = Set.of("scenario", "worlds", "threads", "task");

  private static final int MAX_SAVED_BY_DEFAULT = 1000;

  private static final ObjectMapper MAPPER =
      new ObjectMapper().setPropertyNamingStrategy(PropertyNamingStrategies.SNAKE_CASE);

  static {
    MAPPER
        .coercionConfigFor(LogicalType.Integer)
        .setCoercion(CoercionInputShape.Float, CoercionAction.Fail);
    MAPPER
        .coercionConfigFor(LogicalType.Boolean)
        .setCoercion(CoercionInputShape.Integer, CoercionAction.Fail);
  }

  /**
   * The settings that only environments have; null stands for the default.
   *
   * @param scenario the path of the scenario file
   * @param worlds the number of worlds
   * @param threads the number of threads that share the worlds
   * @param actions view, steps or rates
   * @param targets the number of targets that an observation has space for
   * @param neighbours the number of neighbours that an observation has space for
   * @param belief whether an observation has what each view promises
   * @param paints whether pictures of worlds may be requested
   * @param details whether it is measured what each camera sees, adds and sends
   * @param saves whether worlds may be saved; by default if they are at most 1,000
   * @param expert the policy whose advice is written; null for none
   * @param task the task, if {@code scenario} is a file of tasks; null for a scenario
   */
  record Environment(
      String scenario,
      int worlds,
      int threads,
      String reward,
      String actions,
      Integer targets,
      Integer neighbours,
      boolean belief,
      String autoReset,
      boolean paints,
      boolean details,
      Boolean saves,
      String expert,
      String task) {
    Environment {
      reward = Optional.ofNullable(reward).orElse("coverage");
      actions = Optional.ofNullable(actions).orElse("view");
      targets = Optional.ofNullable(targets).orElse(4);
      neighbours = Optional.ofNullable(neighbours).orElse(2);
      autoReset = Optional.ofNullable(autoReset).orElse("true");
      saves = Optional.ofNullable(saves).orElse(worlds <= MAX_SAVED_BY_DEFAULT);
    }
  }

  static Request parse(String json) {
    ObjectNode environment = MAPPER.createObjectNode();
    try {
      Settings settings = Settings.NONE;
      for (Map.Entry<String, JsonNode> entry : MAPPER.readTree(json).properties()) {
        Optional<Setting> setting = Setting.named(entry.getKey());
        if (setting.isPresent() && SETTINGS.contains(setting.get())) {
          settings = settings.with(setting.get(), entry.getValue().asText());
        } else {
          environment.set(entry.getKey(), entry.getValue());
        }
      }
      return new Request(settings, MAPPER.treeToValue(environment, Environment.class));
    } catch (UnrecognizedPropertyException e) {
      throw InputException.of(
              "unknown setting '%s', expected one of %s",
              e.getPropertyName(),
              Stream.concat(SETTINGS.stream().map(Setting::label), known(e))
                  .collect(Collectors.joining(", ")))
          .because(e);
    } catch (MismatchedInputException e) {
      throw mismatch(e, environment);
    } catch (JsonProcessingException e) {
      throw new InputException("settings: " + e.getOriginalMessage(), e);
    }
  }

  private static InputException mismatch(MismatchedInputException fault, ObjectNode environment) {
    String name = fault.getPath().get(0).getFieldName();
    boolean isNumber = List.of(int.class, Integer.class).contains(fault.getTargetType());
    return InputException.of(
            "%s is '%s', expected %s",
            setting(name),
            environment.get(name).asText(),
            isNumber ? "a whole number" : "True or False")
        .because(fault);
  }

  private static Stream<String> known(UnrecognizedPropertyException fault) {
    return fault.getKnownPropertyIds().stream()
        .map(String::valueOf)
        .filter(name -> !ARGUMENTS.contains(name))
        .sorted();
  }

  /** Reads the scenario, and looks up models, rewards and policies by their names. */
  WorldSettings worldSettings(Catalogue catalogue) {
    Path file = Path.of(environment.scenario);
    Benchmark tasks = environment.task == null ? null : Benchmark.read(file, catalogue);
    if (tasks != null) {
      rejectOtherSettingsThanSeed();
    }
    Scenario scenario =
        tasks == null
            ? settings.scenario(
                ScenarioReader.read(file, catalogue.movements()::knows, warning -> {}))
            : tasks.layout(environment.task, settings.seed());
    // rejects an unknown reward before any world is created
    Rewards.registry().create(environment.reward);
    return new WorldSettings(
        scenario,
        tasks == null ? null : seed -> tasks.layout(environment.task, seed),
        catalogue.movements(),
        DetectionSpec.of(settings, scenario, file, catalogue),
        layout(catalogue, scenario),
        Spelling.require(ActionKind.class, setting("actions"), environment.actions),
        () -> Rewards.registry().create(environment.reward),
        Integer.parseInt(settings.value(Setting.STEPS, scenario)),
        autoReset(),
        environment.expert == null ? null : expert(catalogue));
  }

  private ObservationLayout layout(Catalogue catalogue, Scenario scenario) {
    ObservationLayout layout =
        new ObservationLayout(environment.targets, environment.neighbours, scenario.hasHeights());
    return environment.belief
        ? layout.withViews(mostViews(new World(scenario, catalogue.movements(), 0).cameras()))
        : layout;
  }

  private static int mostViews(Cameras cameras) {
    return IntStream.range(0, cameras.count()).map(cameras::views).max().orElse(0);
  }

  private AutoReset autoReset() {
    return switch (environment.autoReset) {
      case "true" -> AutoReset.SAME_STEP;
      case "false" -> AutoReset.DISABLED;
      default -> Spelling.require(AutoReset.class, setting("auto_reset"), environment.autoReset);
    };
  }

  /** Rejects settings other than the seed, since a task fixes them. */
  private void rejectOtherSettingsThanSeed() {
    SETTINGS.stream()
        .filter(setting -> setting != Setting.SEED && settings.asked(setting).isPresent())
        .findFirst()
        .ifPresent(
            setting -> {
              throw InputException.of(
                  "task %s with %s, expected the seed alone",
                  environment.task, setting(setting.label()));
            });
  }

  /** Returns a factory of experts; rejects an unknown policy, or one that needs the whole run. */
  private Supplier<ZoomPolicy> expert(Catalogue catalogue) {
    if (catalogue.policies().create(environment.expert) instanceof HindsightZoomPolicy) {
      throw InputException.of(
          "%s is '%s', expected a policy that knows no whole run before it begins",
          setting("expert"), environment.expert);
    }
    return () -> catalogue.policies().create(environment.expert);
  }
}
