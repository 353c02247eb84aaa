package org.hificamsim.runs;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.channel.ChannelModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.spec.Headings;
import org.hificamsim.core.scenario.spec.StepOrder;

/**
 * The settings of a run, in the order of files. A setting is declared here alone: its form and
 * meaning, its default, and where a plan has it. The options of commands, keyword arguments of
 * Python, the key of a run's results, {@code settings.json} and the plans that Spark sends follow.
 *
 * <p>What is asked for overrides what the scenario file says, and the file overrides the default.
 */
@SuppressWarnings("ImmutableEnumChecker") // functions
public enum Setting {
  DETECTION(
      Kind.TEXT,
      "NAME|FILE.json[@T|@RULE]",
      "hifi:orb-lin",
      new Holder(
          plan -> plan.detection().name(),
          (name, text) -> {},
          (scenario, text) -> scenario,
          scenario -> scenario.find(Scenario.DETECTION)),
      "Detection model, optionally with a threshold or rule; see 'list detections'."
          + " Without this option the scenario's is used, and the default only if it names none."),
  THRESHOLD(
      Kind.NUMBER,
      "T",
      null,
      new Holder(
          plan -> Double.toString(plan.detection().threshold()),
          (name, text) -> DetectionSpec.threshold(text),
          (scenario, text) -> scenario.withoutOwnRule(),
          null),
      "Detection threshold, 0 to 1; default: T in NAME@T, the scenario's, else the model's."),
  DETECT(
      Kind.TEXT,
      "RULE",
      null,
      new Holder(
          plan -> plan.detection().certain() ? null : plan.detection().rule().text(),
          (name, text) -> DetectionRule.parse(text),
          (scenario, text) -> scenario.withDetect(DetectionRule.parse(text)),
          scenario -> scenario.detect().map(DetectionRule::text)),
      "When a target counts as detected: threshold, if its confidence reaches the threshold;"
          + " chance, by the scatter of the model's fit; probability, with its confidence as"
          + " probability.",
      "Settings of chance: alpha=0.05,memory=N,phantoms=on. Default: the scenario's, else"
          + " threshold."),
  POLICY(
      Kind.TEXT,
      "NAME[:key=value,...]",
      "epsilon-greedy",
      own((name, text) -> {}),
      "The zoom policy; see 'list policies'."),
  OBJECTIVE(
      Kind.TEXT,
      Objective.CHOICES,
      null,
      new Holder(
          plan -> plan.objective().text(),
          (name, text) -> Objective.parse(text),
          (scenario, text) -> scenario.with(Scenario.OBJECTIVE, Objective.parse(text)),
          scenario -> scenario.find(Scenario.OBJECTIVE).map(Objective::text)),
      "The score of a step, and what optimal, one-hop and best-fixed maximise; overrides the"
          + " scenario's. See docs/objectives.md."),
  STEPS(
      Kind.INT,
      "N",
      "1000",
      new Holder(
          null,
          range(1, Scenario.MAX_STEPS),
          (scenario, text) ->
              scenario.with(
                  Scenario.STEPS, scenario.find(Scenario.STEPS).map(any -> Integer.valueOf(text))),
          scenario -> scenario.find(Scenario.STEPS).map(String::valueOf)),
      "Number of steps, 1 to 1,000,000,000. Without this option the scenario's is used, and the"
          + " default only if it names none."),
  SEED(
      Kind.LONG,
      "N",
      "0",
      own(range(Long.MIN_VALUE, Long.MAX_VALUE)),
      "Random seed; with several runs, run i, counted from 0, uses seed + i."),
  REPEAT(Kind.INT, "N", "1", own(range(1, 1_000_000)), "Number of repeats, 1 to 1,000,000."),
  CHANNEL(
      Kind.TEXT,
      "key=value,...",
      null,
      new Holder(
          plan -> plan.scenario().channel().isPerfect() ? null : plan.scenario().channel().text(),
          (name, text) -> ChannelModel.parse(text),
          (scenario, text) -> scenario.with(Scenario.CHANNEL, ChannelModel.parse(text)),
          null),
      "How messages between cameras are lost or delayed, such as "
          + ChannelModel.EXAMPLE
          + ", or perfect; overrides the scenario's. See docs/channel.md."),
  ORDER(
      Kind.TEXT,
      "coverage|camsim",
      null,
      choice(StepOrder.class, Scenario.ORDER),
      "Whether targets move after (coverage) or before (camsim) the observation."),
  HEADINGS(
      Kind.TEXT,
      "degrees|as-radians",
      null,
      choice(Headings.class, Scenario.HEADINGS),
      "Unit of targets' headings; as-radians as in the coverage study's simulator."),
  NETWORK(
      Kind.TEXT,
      "NAME[:key=value,...]",
      "",
      own((name, text) -> {}),
      "Network of the cameras, such as camsim:strategies=A0-P2; default: none, each camera works"
          + " alone. See docs/camsim-studies.md.");

  /** What the values are. */
  public enum Kind {
    TEXT(String.class),
    INT(Integer.class),
    LONG(Long.class),
    NUMBER(Double.class);

    private final Class<?> type;

    Kind(Class<?> type) {
      this.type = type;
    }

    /** The type that holds such a value. */
    public Class<?> type() {
      return type;
    }
  }

  /** Refuses a text that is no value. */
  @FunctionalInterface
  private interface Check {
    void check(String name, String text);
  }

  /**
   * Where a plan has a setting.
   *
   * @param of its value, perhaps null; not needed ({@code null}) for what the plan keeps itself
   * @param check of a value that is asked for
   * @param into changes what a scenario file says
   * @param in what a scenario file says; null for what counts wherever it comes from
   */
  private record Holder(
      Function<RunPlan, String> of,
      Check check,
      BiFunction<Scenario, String, Scenario> into,
      Function<Scenario, Optional<String>> in) {}

  private final Kind kind;
  private final String form;
  private final String fallback;
  private final Holder holder;
  private final String[] meaning;

  Setting(Kind kind, String form, String fallback, Holder holder, String... meaning) {
    this.kind = kind;
    this.form = form;
    this.fallback = fallback;
    this.holder = holder;
    this.meaning = meaning;
  }

  /** A setting of runs alone, such as their number of steps: the plan keeps it. */
  private static Holder own(Check check) {
    return new Holder(null, check, (scenario, text) -> scenario, null);
  }

  /** A setting that is an attribute of scenarios too, which it overrides. */
  private static <E extends Enum<E>> Holder choice(Class<E> type, Property<Scenario, E> property) {
    return new Holder(
        plan -> Spelling.of(plan.scenario().get(property)),
        (name, text) -> Spelling.require(type, name, text),
        (scenario, text) -> scenario.with(property, Spelling.require(type, "", text)),
        null);
  }

  private static Check range(long min, long max) {
    return (name, text) -> {
      try {
        long number = Long.parseLong(text);
        if (number >= min && number <= max) {
          return;
        }
      } catch (NumberFormatException e) {
        // as one that is out of range
      }
      throw InputException.of(
          "%s is %s, expected a whole number from %s to %s", name, text, min, max);
    };
  }

  /** The setting of a name in files, if there is one. */
  public static Optional<Setting> named(String label) {
    return Arrays.stream(values()).filter(one -> one.label().equals(label)).findFirst();
  }

  /** The name in files and of the argument in Python; the option has {@code -} for {@code _}. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** What the values are. */
  public Kind kind() {
    return kind;
  }

  /** What a value looks like, for people. */
  public String form() {
    return form;
  }

  /** What it says, in paragraphs. */
  public String[] meaning() {
    return meaning.clone();
  }

  /** Its default; null where the scenario or the model decides. */
  public String fallback() {
    return fallback;
  }

  /** Whether results tell where it comes from: an option, the scenario or the default. */
  public boolean hasSource() {
    return holder.in != null;
  }

  /** What a scenario says of it; empty where it says nothing. */
  Optional<String> in(Scenario scenario) {
    return hasSource() ? holder.in.apply(scenario) : Optional.empty();
  }

  /** Whether it says which runs there are, and nothing of what each computes. */
  public boolean countsRuns() {
    return this == SEED || this == REPEAT;
  }

  /** Whether plans keep it: neither the scenario nor the detection has it. */
  boolean isOwn() {
    return holder.of == null;
  }

  /** The value in a plan; empty where it does not apply. */
  public Optional<String> of(RunPlan plan) {
    return isOwn()
        ? Optional.of(plan.own().get(this)).filter(value -> !value.isEmpty())
        : Optional.ofNullable(holder.of.apply(plan));
  }

  /**
   * Checks a value.
   *
   * @throws InputException when the setting cannot have it
   */
  void check(String text) {
    holder.check.check(setting(label()), text);
  }

  Scenario into(Scenario scenario, String text) {
    return holder.into.apply(scenario, text);
  }
}
