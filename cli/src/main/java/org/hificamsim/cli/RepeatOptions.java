package org.hificamsim.cli;

import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.runs.RunPlan;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/**
 * How long a run is, and how often it is done: the same limits for every command. A command with
 * many cases keeps 4 bytes for each step of a run under way, and 8 for each step of a case.
 */
final class RepeatOptions {
  private static final int MAX_REPEATS = 1_000_000;

  @Option(names = "--steps", paramLabel = "N", description = "Steps, 1 to 1,000,000,000.")
  private int steps;

  @Option(names = "--repeat", paramLabel = "N", description = "Repeats, 1 to 1,000,000.")
  private int repeats;

  @Mixin private SeedOption seed;

  /**
   * The plan of these runs.
   *
   * @throws InputException when a number is out of range
   */
  RunPlan plan(Scenario scenario, Detection detection, String policy) {
    return new RunPlan(scenario, detection, policy, steps(), seed(), repeats());
  }

  int steps() {
    return Numbers.inRange("--steps", steps, 1, RunPlan.MAX_STEPS);
  }

  int repeats() {
    return Numbers.inRange("--repeat", repeats, 1, MAX_REPEATS);
  }

  /** The first seed: the last repeat's is a whole number of 64 bits too. */
  long seed() {
    long max = Long.MAX_VALUE - (repeats() - 1);
    if (seed.value() > max) {
      throw new InputException(
          "--seed is %s, expected at most %s for %s repeats".formatted(seed.value(), max, repeats));
    }
    return seed.value();
  }
}
