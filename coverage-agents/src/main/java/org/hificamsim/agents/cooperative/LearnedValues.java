package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.agents.cooperative.Parameters.Learn;

/**
 * What each view of a camera has been worth a step beyond what the model says, in the units of the
 * objective: the values that a bandit or SARSA without states learns from the model's errors
 * (residual reinforcement learning: Johannink and others, 2019). A view behind a wall that is not
 * on the map has a negative one.
 */
final class LearnedValues {
  private static final double RATE = 0.1; // of SARSA

  private final Worth worth;
  private final Learn learn;
  private final double discount;
  private final double[][] values; // by camera and view; empty where nothing is learned
  private final int[][] looks;
  private final double[] errors; // by camera: what it added less what the model says, in this step
  private final int[] before; // view that the camera looked through last
  private final double[] errorsBefore;

  LearnedValues(Parameters parameters, Worth worth, int[] views) {
    this.worth = worth;
    learn = parameters.learn();
    discount = parameters.discount();
    values = new double[learns() ? views.length : 0][];
    looks = new int[values.length][];
    for (int camera = 0; camera < values.length; camera++) {
      values[camera] = new double[views[camera]];
      looks[camera] = new int[views[camera]];
    }
    errors = new double[values.length];
    errorsBefore = new double[values.length];
    before = new int[values.length];
    Arrays.fill(before, Plan.NONE);
  }

  /** Whether anything is learned of views. */
  boolean learns() {
    return learn == Learn.BANDIT || learn == Learn.SARSA;
  }

  /**
   * A camera should see a target, and does or does not.
   *
   * @param chance that it sees it, by the model
   * @param weight how likely the target is there
   * @param others how many other cameras see it
   */
  void see(int camera, double chance, double weight, int others, boolean itDoes) {
    double added = others < worth.most() ? worth.added(others) : 0;
    errors[camera] += weight * added * ((itDoes ? 1 : 0) - chance);
  }

  /** All that a camera saw in a step through a view is known. */
  void learn(int camera, int view) {
    if (!learns()) {
      return;
    }
    double[] of = values[camera];
    if (learn == Learn.BANDIT) {
      of[view] += (errors[camera] - of[view]) / ++looks[camera][view];
    } else if (before[camera] != Plan.NONE) {
      double target = errorsBefore[camera] + discount * of[view];
      of[before[camera]] += RATE * (target - of[before[camera]]);
    }
    before[camera] = view;
    errorsBefore[camera] = errors[camera];
    errors[camera] = 0;
  }

  /**
   * What a view is worth beyond what the model says.
   *
   * @param steps what the steps count together in which the camera looks through it
   */
  double correction(int camera, int view, double steps) {
    if (!learns()) {
      return 0;
    }
    return learn == Learn.BANDIT ? steps * values[camera][view] : values[camera][view];
  }
}
