package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.agents.cooperative.Parameters.Learn;

/**
 * Learns what each view of a camera is worth in a step beyond what the model promises, in the units
 * of the objective: values that a bandit, or SARSA without states, learns from the model's errors
 * (residual reinforcement learning: Johannink and others, 2019). A view behind a wall that is not
 * on the map gets a negative value.
 */
final class LearnedValues {
  private static final double SARSA_RATE = 0.1;

  private final Worth worth;
  private final Learn learn;
  private final double discount;

  /** The values by camera and view; empty if nothing is learned. */
  private final double[][] values;

  private final int[][] lookCounts;

  /** The worth that each camera added in this step, minus what the model promised. */
  private final double[] errors;

  private final int[] lastViews;
  private final double[] lastErrors;

  /**
   * @param views number of views, by camera
   */
  LearnedValues(Parameters parameters, Worth worth, int[] views) {
    this.worth = worth;
    learn = parameters.learn();
    discount = parameters.discount();
    values = new double[learns() ? views.length : 0][];
    lookCounts = new int[values.length][];
    for (int camera = 0; camera < values.length; camera++) {
      values[camera] = new double[views[camera]];
      lookCounts[camera] = new int[views[camera]];
    }
    errors = new double[values.length];
    lastErrors = new double[values.length];
    lastViews = new int[values.length];
    Arrays.fill(lastViews, Plan.NONE);
  }

  /** Whether values of views are learned. */
  boolean learns() {
    return learn == Learn.BANDIT || learn == Learn.SARSA;
  }

  /**
   * Compares with the model whether a camera saw a target.
   *
   * @param chance the model's chance that the camera sees the target
   * @param weight probability that the target is there
   * @param others number of other cameras that see the target
   */
  void compare(int camera, double chance, double weight, int others, boolean isSeen) {
    double added = others < worth.saturation() ? worth.added(others) : 0;
    errors[camera] += weight * added * ((isSeen ? 1 : 0) - chance);
  }

  /** Learns from a camera's comparisons of one step, in which it had this view. */
  void learn(int camera, int view) {
    if (!learns()) {
      return;
    }
    double[] viewValues = values[camera];
    int lastView = lastViews[camera];
    if (learn == Learn.BANDIT) {
      viewValues[view] += (errors[camera] - viewValues[view]) / ++lookCounts[camera][view];
    } else if (lastView != Plan.NONE) {
      double target = lastErrors[camera] + discount * viewValues[view];
      viewValues[lastView] += SARSA_RATE * (target - viewValues[lastView]);
    }
    lastViews[camera] = view;
    lastErrors[camera] = errors[camera];
    errors[camera] = 0;
  }

  /**
   * Returns the learned worth of a view beyond what the model promises.
   *
   * @param stepWeight sum of the weights of the steps in which the camera has the view
   */
  double correction(int camera, int view, double stepWeight) {
    if (!learns()) {
      return 0;
    }
    return learn == Learn.BANDIT ? stepWeight * values[camera][view] : values[camera][view];
  }
}
