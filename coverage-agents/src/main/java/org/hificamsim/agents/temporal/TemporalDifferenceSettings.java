package org.hificamsim.agents.temporal;

import org.hificamsim.agents.choice.Ties;
import org.hificamsim.agents.choice.Utility;
import org.hificamsim.core.registry.Options;

/**
 * The parameters of Eqs 7.5 and 7.6, and the readings that the thesis leaves open.
 *
 * @param alpha learning rate, [0, 1]; 0.1 in thesis 7.4.4
 * @param gamma discount factor, [0, 1]; not published
 * @param lambda factor on every reward, 0 or more
 * @param initialValue value of every action in every state at first
 */
public record TemporalDifferenceSettings(
    StateReading state,
    RewardReading reward,
    Utility.Reading utility,
    double alpha,
    double gamma,
    double lambda,
    double initialValue,
    Ties ties) {
  private static final double LARGE = 1e6;

  /** The options, each with the default that comes closest to Table 8.1. */
  public static TemporalDifferenceSettings from(Options options) {
    return new TemporalDifferenceSettings(
        options.choice(
            "state",
            StateReading.LEVEL_COUNT,
            "what a camera knows: level-count, count, none, picture, view-picture, picture-depth,"
                + " view-picture-depth"),
        options.choice(
            "reward", RewardReading.COUNT_CHANGE, "Eq 7.5 as: count-change, sign, literal"),
        Utility.from(options),
        options.number("alpha", 0.1, 0, 1, "learning rate"),
        options.number("gamma", 0.9, 0, 1, "discount factor"),
        options.number("lambda", 1, 0, LARGE, "factor on every reward"),
        options.number("q0", 0, -LARGE, LARGE, "value of every action at first"),
        Ties.from(options, Ties.WIDEST));
  }
}
