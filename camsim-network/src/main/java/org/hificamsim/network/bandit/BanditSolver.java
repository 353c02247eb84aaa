package org.hificamsim.network.bandit;

import java.util.Map;
import java.util.Random;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * The bandit of one camera: chooses among six arms at intervals, and learns from the results fed to
 * it in between (behaviour 9.1 and 9.2).
 */
public final class BanditSolver {
  /** No arm. */
  static final int NONE = -1;

  private final BanditAlgorithm algorithm;
  private final BanditParameters parameters;
  private final Random random;
  private final Arms arms;

  /** The number of times that each amount of communication has occurred. */
  private final SortedMap<Double, Integer> communicationCounts = new TreeMap<>();

  private int current = NONE;
  private int interval;
  private int steps;
  private double performance;
  private double communication;

  /** Creates a bandit without experience; draws one number per arm. */
  public BanditSolver(BanditAlgorithm algorithm, BanditParameters parameters, Random random) {
    this.algorithm = algorithm;
    this.parameters = parameters.usedBy(algorithm);
    this.random = random;
    this.arms = new Arms(random);
    this.interval = parameters.interval();
    this.steps = interval;
  }

  /**
   * Learns and chooses again at the end of an interval; returns the current arm or {@link #NONE}.
   */
  int select() {
    if (steps >= interval) {
      if (current != NONE) {
        learn();
      }
      choose();
    }
    return current;
  }

  /** Adds the results of a step under the current arm. */
  void feed(double stepPerformance, double stepCommunication) {
    performance += stepPerformance;
    communication += stepCommunication;
    steps++;
  }

  private void learn() {
    double cost = shareBelow(communication, communicationCounts);
    communicationCounts.merge(communication, 1, Integer::sum);
    arms.reward(current, parameters.alpha() * performance - (1 - parameters.alpha()) * cost);
    performance = 0;
    communication = 0;
    steps = 0;
  }

  /** The share of the counted values that are smaller than {@code value}; 0 without any. */
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

  /** Chooses an arm now, before the interval ends. */
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
