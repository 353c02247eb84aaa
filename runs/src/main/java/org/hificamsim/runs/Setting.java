package org.hificamsim.runs;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.channel.ChannelModel;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.energy.EnergyModel;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Following;
import org.hificamsim.core.scenario.spec.Headings;
import org.hificamsim.core.scenario.spec.ProcessingBudget;
import org.hificamsim.core.scenario.spec.StepOrder;

/**
 * The settings of a run, in the order of files. A setting is declared only here: its form, meaning
 * and default, who keeps its value, and how a value changes a scenario. The options of commands,
 * keyword arguments of Python, the key of a run's results, {@code settings.json} and the plans that
 * Spark sends follow.
 *
 * <p>What a user asks for overrides what the scenario file says, and the file overrides the
 * default.
 */
@SuppressWarnings("ImmutableEnumChecker") // the array of paragraphs never changes
public enum Setting {
  DETECTION(
      Kind.TEXT,
      "NAME|FILE.json[@T|@RULE]",
      "hifi:orb-lin",
      Keeper.DETECTION,
      "Detection model, optionally with a threshold or rule; see 'list detections'."
          + " Without this option the scenario's is used, and the default only if it names none.") {
    @Override
    boolean mayComeFromFile() {
      return true;
    }

    @Override
    Optional<String> inFile(Scenario scenario) {
      return scenario.find(Scenario.DETECTION);
    }

    @Override
    Optional<String> derivedFrom(Scenario scenario, Detection detection) {
      return Optional.of(detection.name());
    }
  },
  THRESHOLD(
      Kind.NUMBER,
      "T",
      null,
      Keeper.DETECTION,
      "Detection threshold, 0 to 1; default: T in NAME@T, the scenario's, else the model's.") {
    @Override
    void check(String text) {
      Threshold.parse(text);
    }

    @Override
    Scenario override(Scenario scenario, String text) {
      return scenario.withoutOwnRule();
    }

    @Override
    Optional<String> derivedFrom(Scenario scenario, Detection detection) {
      return Optional.of(Double.toString(detection.threshold()));
    }
  },
  DETECT(
      Kind.TEXT,
      "RULE",
      null,
      Keeper.DETECTION,
      "When a target counts as detected: threshold, if its confidence reaches the threshold;"
          + " chance, by the scatter of the model's fit; probability, with its confidence as"
          + " probability.",
      "Settings of chance: alpha=0.05,memory=N,phantoms=on. Default: the scenario's, else"
          + " threshold.") {
    @Override
    void check(String text) {
      DetectionRule.parse(text);
    }

    @Override
    boolean mayComeFromFile() {
      return true;
    }

    @Override
    Optional<String> inFile(Scenario scenario) {
      return scenario.detect().map(DetectionRule::text);
    }

    @Override
    Scenario override(Scenario scenario, String text) {
      return scenario.withDetect(DetectionRule.parse(text));
    }

    @Override
    Optional<String> derivedFrom(Scenario scenario, Detection detection) {
      return detection.certain() ? Optional.empty() : Optional.of(detection.rule().text());
    }
  },
  POLICY(
      Kind.TEXT,
      "NAME[:key=value,...]",
      "epsilon-greedy",
      Keeper.PLAN,
      "The zoom policy; see 'list policies'."),
  OBJECTIVE(
      Objective.CHOICES,
      new ScenarioAttribute<>(Scenario.OBJECTIVE, Objective::parse),
      "The score of a step, and what optimal, one-hop and best-fixed maximise; overrides the"
          + " scenario's. See docs/objectives.md.") {
    @Override
    boolean mayComeFromFile() {
      return true;
    }

    @Override
    Optional<String> inFile(Scenario scenario) {
      return scenario.find(Scenario.OBJECTIVE).map(Objective::text);
    }

    @Override
    Optional<String> derivedFrom(Scenario scenario, Detection detection) {
      return Optional.of(scenario.objective().text());
    }
  },
  STEPS(
      Kind.INT,
      "N",
      "1000",
      Keeper.PLAN,
      "Number of steps, 1 to 1,000,000,000. Without this option the scenario's is used, and the"
          + " default only if it names none.") {
    @Override
    void check(String text) {
      requireWhole(text, 1, Scenario.MAX_STEPS);
    }

    @Override
    boolean mayComeFromFile() {
      return true;
    }

    @Override
    Optional<String> inFile(Scenario scenario) {
      return scenario.find(Scenario.STEPS).map(String::valueOf);
    }

    /** Replaces the number of steps, unless the scenario names none. */
    @Override
    Scenario override(Scenario scenario, String text) {
      return scenario.find(Scenario.STEPS).isPresent()
          ? scenario.with(Scenario.STEPS, Integer.valueOf(text))
          : scenario;
    }
  },
  SEED(
      Kind.LONG,
      "N",
      "0",
      Keeper.PLAN,
      "Random seed; with several runs, run i, counted from 0, uses seed + i.") {
    @Override
    void check(String text) {
      requireWhole(text, Long.MIN_VALUE, Long.MAX_VALUE);
    }
  },
  REPEAT(Kind.INT, "N", "1", Keeper.PLAN, "Number of repeats, 1 to 1,000,000.") {
    @Override
    void check(String text) {
      requireWhole(text, 1, 1_000_000);
    }
  },
  CHANNEL(
      "key=value,...",
      new ScenarioAttribute<>(Scenario.CHANNEL, ChannelModel::parse),
      "How messages between cameras are lost or delayed, such as "
          + ChannelModel.EXAMPLE
          + ", or perfect; overrides the scenario's. See docs/channel.md."),
  ENERGY(
      "PROFILE|FILE|key=value,...",
      new ScenarioAttribute<>(Scenario.ENERGY, EnergyModel::parseOrRead),
      "What cameras take and what their batteries hold, such as "
          + EnergyModel.EXAMPLE
          + ", a file with such lines, or none; overrides the scenario's. See docs/energy.md.") {
    /** A metric in the same files is called energy. */
    @Override
    public String field() {
      return "energy_model";
    }
  },
  PROCESSING(
      "N",
      new ScenarioAttribute<>(Scenario.PROCESSING, ProcessingBudget::parse),
      "How many detections a camera processes in a step, 1 or more, or none for all; the others"
          + " come a step late. Overrides the scenario's. See docs/following.md."),
  FOLLOWING(
      "none|targets",
      new ScenarioAttribute<>(
          Scenario.FOLLOWING,
          text -> Spelling.require(Following.class, setting("following"), text)),
      "Whether it is measured how cameras follow each target; overrides the scenario's. See"
          + " docs/following.md."),
  ORDER(
      "coverage|camsim",
      new ScenarioAttribute<>(
          Scenario.ORDER, text -> Spelling.require(StepOrder.class, setting("order"), text)),
      "Whether targets move after (coverage) or before (camsim) the observation."),
  HEADINGS(
      "degrees|as-radians",
      new ScenarioAttribute<>(
          Scenario.HEADINGS, text -> Spelling.require(Headings.class, setting("headings"), text)),
      "Unit of targets' headings; as-radians as in the coverage study's simulator."),
  NETWORK(
      Kind.TEXT,
      "NAME[:key=value,...]",
      "",
      Keeper.PLAN,
      "Network of the cameras, such as camsim:strategies=A0-P2; default: none, each camera works"
          + " alone. See docs/camsim-studies.md.");

  /** The type of a setting's values. */
  public enum Kind {
    TEXT(String.class),
    INT(Integer.class),
    LONG(Long.class),
    NUMBER(Double.class);

    private final Class<?> type;

    Kind(Class<?> type) {
      this.type = type;
    }

    /** The Java type that holds such a value. */
    public Class<?> type() {
      return type;
    }
  }

  /** The part of a plan of runs that keeps a setting's value. */
  private enum Keeper {
    SCENARIO,
    DETECTION,
    /** The plan itself, by the setting. */
    PLAN
  }

  private final Kind kind;
  private final String form;
  private final String fallback;
  private final Keeper keeper;

  /** The attribute of scenario files that has the value; null if none has it. */
  private final ScenarioAttribute<?> attribute;

  private final String[] meaning;

  /** A setting that a plan or its detection keeps. */
  Setting(Kind kind, String form, String fallback, Keeper keeper, String... meaning) {
    this(kind, form, fallback, keeper, null, meaning);
  }

  /** A setting that an attribute of the plan's scenario keeps. */
  Setting(String form, ScenarioAttribute<?> attribute, String... meaning) {
    this(Kind.TEXT, form, null, Keeper.SCENARIO, attribute, meaning);
  }

  Setting(
      Kind kind,
      String form,
      String fallback,
      Keeper keeper,
      ScenarioAttribute<?> attribute,
      String[] meaning) {
    this.kind = kind;
    this.form = form;
    this.fallback = fallback;
    this.keeper = keeper;
    this.attribute = attribute;
    this.meaning = meaning;
  }

  /** The setting of a name in files, if there is one. */
  public static Optional<Setting> named(String label) {
    return Arrays.stream(values()).filter(setting -> setting.label().equals(label)).findFirst();
  }

  /** The name in files: the {@link #label}, unless a metric has the same name. */
  public String field() {
    return label();
  }

  /** The name of the argument in Python; the option has {@code -} in place of {@code _}. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The type of the values. */
  public Kind kind() {
    return kind;
  }

  /** The form of a value, for help texts. */
  public String form() {
    return form;
  }

  /** The meaning for help texts, in paragraphs. */
  public String[] meaning() {
    return meaning.clone();
  }

  /** The default; null if the scenario or the detection model decides. */
  public String fallback() {
    return fallback;
  }

  /** Whether the setting only selects runs, and has no effect on what each of them computes. */
  public boolean countsRuns() {
    return this == SEED || this == REPEAT;
  }

  /** Whether a plan keeps the value itself, and not in its scenario or detection. */
  boolean isKeptByPlan() {
    return keeper == Keeper.PLAN;
  }

  /**
   * Checks a value. Any text is valid unless an attribute or the setting itself restricts it.
   *
   * @throws InputException when the setting cannot have it
   */
  void check(String text) {
    if (attribute != null) {
      attribute.check(text);
    }
  }

  /**
   * Whether results say the source of the value: an option, the scenario file or the default. If
   * so, {@link #inFile} reads the value from the file.
   */
  boolean mayComeFromFile() {
    return false;
  }

  /** The value that a scenario file has; empty if it has none. */
  Optional<String> inFile(Scenario scenario) {
    return Optional.empty();
  }

  /** The scenario with this value in place of what its file says. */
  Scenario override(Scenario scenario, String text) {
    return attribute == null ? scenario : attribute.override(scenario, text);
  }

  /**
   * The value that a scenario and a detection keep; empty if the setting does not apply to them.
   */
  Optional<String> derivedFrom(Scenario scenario, Detection detection) {
    if (attribute == null) {
      throw new IllegalStateException(label() + " is kept by the plan");
    }
    return attribute.text(scenario);
  }

  /** Fails unless a text is a whole number from {@code min} to {@code max}. */
  void requireWhole(String text, long min, long max) {
    try {
      long number = Long.parseLong(text);
      if (number >= min && number <= max) {
        return;
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw InputException.of(
        "%s is %s, expected a whole number from %s to %s", setting(label()), text, min, max);
  }
}
