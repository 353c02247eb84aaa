package org.hificamsim.network.bandit;

import java.util.Random;

/**
 * One camera's bandit: chooses among six arms now and then, and learns from what it is fed between
 * (behaviour 9.1 and 9.2).
 */
public final class BanditSolver {
  /** No arm. */
  public static final int NONE = -1;

  private final ArmChoice choice;
  private final BanditParameters parameters;
  private final Random random;
  private final Arms arms;
  private final Ranks communications = new Ranks();
  private int current = NONE;
  private int interval;
  private int steps;
  private double performance;
  private double communication;

  BanditSolver(ArmChoice choice, BanditParameters parameters, Random random) {
    this.choice = choice;
    this.parameters = parameters;
    this.random = random;
    this.arms = new Arms(random);
    this.interval = parameters.interval();
    this.steps = interval;
  }

  /** Learns and chooses anew if it is time; returns the current arm, or {@link #NONE}. */
  public int select() {
    if (steps >= interval) {
      if (current != NONE) {
        learn();
      }
      choose();
    }
    return current;
  }

  /** Takes what a step brought under the current arm. */
  public void feed(double stepPerformance, double stepCommunication) {
    performance += stepPerformance;
    communication += stepCommunication;
    steps++;
  }

  private void learn() {
    double cost = communications.shareBelow(communication);
    communications.add(communication);
    arms.reward(current, parameters.alpha() * performance - (1 - parameters.alpha()) * cost);
    performance = 0;
    communication = 0;
    steps = 0;
  }

  /** Chooses an arm at once. */
  void choose() {
    int arm = choice.choose(arms, random);
    if (arm != NONE) {
      current = arm;
    }
    interval = choice.interval(interval);
  }

  int current() {
    return current;
  }

  Arms arms() {
    return arms;
  }

  BanditParameters parameters() {
    return parameters;
  }
}
