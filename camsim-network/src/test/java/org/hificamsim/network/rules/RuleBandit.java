package org.hificamsim.network.rules;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** The bandit of a camera that chooses its own range (9.1, 9.3, 9.6). */
final class RuleBandit {
  private static final double WIDTH = 20.0 / 6;
  private static final double ALPHA = 0.5;

  private final String algorithm;
  private final Random random;
  private final double beta;
  private final int[] counts = {1, 1, 1, 1, 1, 1};
  private final double[] rewards = new double[6];
  private final List<Double> ratios = new ArrayList<>();
  private final List<Double> overlapRatios = new ArrayList<>();
  private int current = -1;
  private int ticks;
  int sharedViews;
  int theirViews;
  int privateViews;

  RuleBandit(String name, Random random) {
    algorithm = name.substring(name.lastIndexOf('.') + 1);
    this.random = random;
    beta = algorithm.equals("SoftMax") ? 0.5 : 0;
    for (int arm = 0; arm < 6; arm++) {
      rewards[arm] = random.nextDouble() / 1000000;
    }
  }

  /** Learns after a camera's update, and returns its range from now on. */
  double learn(int owned, int tracked, double range) {
    if (owned > 0) {
      ratios.add((double) tracked / owned);
    }
    int views = sharedViews + theirViews + privateViews;
    if (views > 0) {
      overlapRatios.add((double) sharedViews / views);
    }
    sharedViews = 0;
    theirViews = 0;
    privateViews = 0;
    return ++ticks > 10 ? choose(range) : range;
  }

  private double choose(double range) {
    int arm = current == -1 ? (int) Math.floor(range / WIDTH) : current;
    rewards[arm] += ALPHA * mean(ratios) + beta * mean(overlapRatios);
    counts[arm]++;
    int chosen = choice();
    current = chosen == -1 ? current : chosen;
    forget();
    ticks = 0;
    if (current == -1) {
      return range;
    }
    double wider = range + ((current + 1) * WIDTH - range);
    return wider >= 20 ? 16.0 : wider;
  }

  /** Forgets the ratios that were stored since the last choice. */
  void forget() {
    ratios.clear();
    overlapRatios.clear();
  }

  private static double mean(List<Double> values) {
    double sum = 0.0;
    for (double value : values) {
      sum += value;
    }
    return values.isEmpty() ? 0 : sum / values.size();
  }

  private int choice() {
    return switch (algorithm) {
      case "EpsilonGreedy" -> random.nextDouble() < 0.1 ? random.nextInt(6) : best(new double[6]);
      case "UCB1" -> best(margins());
      default -> softMax();
    };
  }

  private double[] margins() {
    int total = 0;
    for (int count : counts) {
      total += count;
    }
    double[] margins = new double[6];
    for (int arm = 0; arm < 6; arm++) {
      margins[arm] = Math.sqrt((2 * Math.log(total)) / counts[arm]);
    }
    return margins;
  }

  private int best(double[] margins) {
    int best = 0;
    for (int arm = 1; arm < 6; arm++) {
      if (meanOf(arm) + margins[arm] > meanOf(best) + margins[best]) {
        best = arm;
      }
    }
    return best;
  }

  private double meanOf(int arm) {
    return rewards[arm] / counts[arm];
  }

  private int softMax() {
    double sum = 0.0;
    for (int arm = 0; arm < 6; arm++) {
      sum += Math.exp(meanOf(arm) / 0.1);
    }
    double left = random.nextDouble() * sum;
    int subtractions = 0;
    while (left > 0 && subtractions < 6) {
      left -= Math.exp(meanOf(subtractions++) / 0.1);
    }
    return subtractions - 1;
  }
}
