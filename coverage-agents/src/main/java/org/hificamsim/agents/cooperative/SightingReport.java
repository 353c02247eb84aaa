package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.channel.MessageBits;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;

/** The message that a camera sends to the others in each step: its view, and its detections. */
final class SightingReport {
  /** The number of a target that is not identified. */
  static final int UNIDENTIFIED = -1;

  private final boolean identifies;
  private int camera;
  private int view;
  private long step;
  private int count;
  private int[] targets = {};

  /** The true numbers of the seen targets, only to count identity switches. */
  private int[] trueTargets = {};

  private double[] xs = {};
  private double[] ys = {};
  private double[] sizes = {};

  /**
   * @param identifies whether the report identifies targets
   */
  SightingReport(boolean identifies) {
    this.identifies = identifies;
  }

  /** Begins the report of a step, with no target yet. */
  void begin(NetworkView network, int newCamera) {
    camera = newCamera;
    view = network.online(camera) ? network.seeing(camera) : -1;
    step = network.step();
    count = 0;
  }

  /** Adds a target that the camera sees, at the position that follows from the camera's pose. */
  void add(NetworkView network, SeenPairs pairs, int pair) {
    if (count == targets.length) {
      grow(Math.max(4, 2 * count));
    }
    double axis = network.cameraHeading(camera) + network.pan(camera, view);
    double aheadX = Math.sin(axis);
    double aheadY = Math.cos(axis);
    double ahead = pairs.ahead(pair);
    double right = pairs.right(pair);
    trueTargets[count] = pairs.target(pair);
    targets[count] = identifies ? pairs.target(pair) : UNIDENTIFIED;
    sizes[count] = network.targetSize(pairs.target(pair));
    xs[count] = network.cameraX(camera) + ahead * aheadX + right * aheadY;
    ys[count++] = network.cameraY(camera) + ahead * aheadY - right * aheadX;
  }

  /** Returns a copy, which may arrive in a later step. */
  SightingReport copy() {
    return copy(targets);
  }

  /**
   * Returns a copy with other numbers of targets.
   *
   * @param numbers the numbers by sighting; further entries are ignored
   */
  SightingReport copy(int[] numbers) {
    SightingReport copy = new SightingReport(identifies);
    copy.camera = camera;
    copy.view = view;
    copy.step = step;
    copy.count = count;
    copy.targets = Arrays.copyOf(numbers, count);
    copy.trueTargets = Arrays.copyOf(trueTargets, count);
    copy.xs = Arrays.copyOf(xs, count);
    copy.ys = Arrays.copyOf(ys, count);
    copy.sizes = Arrays.copyOf(sizes, count);
    return copy;
  }

  /** The length of the report, in bits: the view, or none, and each target's position and size. */
  int bits(NetworkView network) {
    int bitsPerTarget = (identifies ? MessageBits.of(network.targets()) : 0) + 3 * MessageBits.REAL;
    return MessageBits.address(network.cameras())
        + MessageBits.of(network.views(camera) + 1L)
        + count * bitsPerTarget;
  }

  private void grow(int length) {
    targets = Arrays.copyOf(targets, length);
    trueTargets = Arrays.copyOf(trueTargets, length);
    xs = Arrays.copyOf(xs, length);
    ys = Arrays.copyOf(ys, length);
    sizes = Arrays.copyOf(sizes, length);
  }

  /** The camera that reports. */
  int camera() {
    return camera;
  }

  /** The view through which the camera looks; -1 for none. */
  int view() {
    return view;
  }

  /** The step of the sightings. */
  long step() {
    return step;
  }

  /** Whether the camera sees the target with this number. */
  boolean has(int target) {
    boolean has = false;
    for (int i = 0; i < count; i++) {
      has |= targets[i] == target;
    }
    return has;
  }

  /** The number of targets that the camera sees. */
  int count() {
    return count;
  }

  /** The number of the i-th target, or {@link #UNIDENTIFIED}. */
  int target(int i) {
    return targets[i];
  }

  /** The true number of the i-th target, only to count identity switches. */
  int trueTarget(int i) {
    return trueTargets[i];
  }

  /** The position of the i-th target, in metres. */
  double x(int i) {
    return xs[i];
  }

  double y(int i) {
    return ys[i];
  }

  /** The size of the i-th target, in metres; NaN if it is unknown. */
  double size(int i) {
    return sizes[i];
  }
}
