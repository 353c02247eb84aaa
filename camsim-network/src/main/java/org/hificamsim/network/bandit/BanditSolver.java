package org.hificamsim.network.bandit;

import java.util.Map;
import java.util.Random;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * One camera's bandit: chooses among six arms now and then, and learns from what it is fed between
 * (behaviour 9.1 and 9.2).
 */
public final class BanditSolver {
  /** No arm. */
  static final int NONE = -1;

  private final BanditAlgorithm algorithm;
  private final BanditParameters parameters;
  private final Random random;
  private final Arms arms;
  private final SortedMap<Double, Integer> communications = new TreeMap<>(); // how often each was
  private int current = NONE;
  private int interval;
  private int steps;
  private double performance;
  private double communication;

  /** A bandit that knows nothing; draws one number per arm. */
  public BanditSolver(BanditAlgorithm algorithm, BanditParameters parameters, Random random) {
    this.algorithm = algorithm;
    this.parameters = parameters.of(algorithm);
    this.random = random;
    this.arms = new Arms(random);
    this.interval = parameters.interval();
    this.steps = interval;
  }

  /** Learns and chooses again if it is time; returns the current arm, or {@link #NONE}. */
  int select() {
    if (steps >= interval) {
      if (current != NONE) {
        learn();
      }
      choose();
    }
    return current;
  }

  /** Takes what a step brought under the current arm. */
  void feed(double stepPerformance, double stepCommunication) {
    performance += stepPerformance;
    communication += stepCommunication;
    steps++;
  }

  private void learn() {
    double cost = shareBelow(communication, communications);
    communications.merge(communication, 1, Integer::sum);
    arms.reward(current, parameters.alpha() * performance - (1 - parameters.alpha()) * cost);
    performance = 0;
    communication = 0;
    steps = 0;
  }

  /** The share of values that are strictly smaller than one; 0 without any. */
  static double shareBelow(double value, SortedMap<Double, Integer> counts) {
    return counts.isEmpty() ? 0 : (double) sum(counts.headMap(value)) / sum(counts);
  }

  private static int sum(Map<Double, Integer> counts) {
    int sum = 0;
    for (int count : counts.values()) {
      sum += count;
    }
    return sum;
  }

  /** Chooses an arm at once. */
  void choose() {
    int arm = algorithm.choose(arms, parameters.epsilon(), random);
    if (arm != NONE) {
      current = arm;
      interval = algorithm.interval(arms.chosen(arm), parameters);
      arms.choose(arm);
    }
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
