package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;

/**
 * The expected result of each view of a camera, according to its belief before it decides. Numbers
 * of targets are means over the steps of the horizon, where later steps weigh less and the steps of
 * the move count as none.
 */
public final class ViewOutlook {
  private int views;
  private int[] delays = {};
  private double[] targets = {};
  private double[] covered = {};
  private double[] known = {};
  private double[] unseen = {};
  private double[] gains = {};

  ViewOutlook() {}

  /** Clears the outlook. */
  void begin(int newViews) {
    views = newViews;
    if (delays.length < views) {
      delays = new int[views];
      targets = new double[views];
      covered = new double[views];
      known = new double[views];
      unseen = new double[views];
      gains = new double[views];
    }
    Arrays.fill(targets, 0);
    Arrays.fill(covered, 0);
    Arrays.fill(known, 0);
  }

  /** Takes in what a plan expects in which the other cameras go on with their last choices. */
  void read(NetworkView network, int camera, Plan plan) {
    begin(network.views(camera));
    double[] planned = plan.gains(network, camera);
    plan.fillOutlook(camera, this);
    for (int view = 0; view < views; view++) {
      gains[view] = planned[view] / plan.discountedSteps();
      delays[view] = network.stepsTo(camera, view);
      targets[view] /= plan.discountedSteps();
      covered[view] /= plan.discountedSteps();
      known[view] /= plan.discountedSteps();
    }
  }

  /**
   * Adds a known target in a step to those of a view.
   *
   * @param detections expected number of detections
   * @param others the chance that another camera detects it
   * @param added worth of a detection beyond what others cover
   */
  void addKnown(int view, double detections, double others, double added) {
    targets[view] += detections;
    covered[view] += detections * others;
    known[view] += detections * added;
  }

  void setUnseen(int view, double expected) {
    unseen[view] = expected;
  }

  /** The number of views; 0 for a camera that is off. */
  public int views() {
    return views;
  }

  /** The number of steps before the first one in which the camera sees through a view. */
  public int delay(int view) {
    return delays[view];
  }

  /** The number of known targets that the camera is expected to detect in a view. */
  public double targets(int view) {
    return targets[view];
  }

  /** Returns the part of {@link #targets} that other cameras are expected to detect as well. */
  public double covered(int view) {
    return covered[view];
  }

  /** The worth of the known targets in a view, beyond what the other cameras cover. */
  public double known(int view) {
    return known[view];
  }

  /** The number of targets expected in a view that no camera sees. */
  public double unseen(int view) {
    return unseen[view];
  }

  /**
   * The worth, per step, of the best way that sets out for a view now: what it adds by known and
   * unseen targets if the other cameras keep to their last choices.
   */
  public double gain(int view) {
    return gains[view];
  }
}
