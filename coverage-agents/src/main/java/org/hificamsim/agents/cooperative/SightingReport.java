package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.channel.MessageBits;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;

/**
 * What a camera tells the others in each step: the view that it looks through, and what it sees.
 */
final class SightingReport {
  /** In place of the number of a target that is not identified. */
  static final int UNNAMED = -1;

  private final boolean named;
  private int camera;
  private int view;
  private long step;
  private int count;
  private int[] targets = {};
  private double[] x = {};
  private double[] y = {};
  private double[] sizes = {};

  /**
   * @param named whether it says which target is which
   */
  SightingReport(boolean named) {
    this.named = named;
  }

  /** Begins a report of a camera that has seen nothing yet. */
  void begin(NetworkView network, int newCamera) {
    camera = newCamera;
    view = network.online(camera) ? network.seeing(camera) : -1;
    step = network.step();
    count = 0;
  }

  /** Adds a target that the camera sees: its place follows from the camera's pose. */
  void add(NetworkView network, SeenPairs pairs, int pair) {
    if (count == targets.length) {
      grow(Math.max(4, 2 * count));
    }
    double axis = network.cameraHeading(camera) + network.pan(camera, view);
    double aheadX = Math.sin(axis);
    double aheadY = Math.cos(axis);
    double ahead = pairs.ahead(pair);
    double right = pairs.right(pair);
    targets[count] = named ? pairs.target(pair) : UNNAMED;
    sizes[count] = network.targetSize(pairs.target(pair));
    x[count] = network.cameraX(camera) + ahead * aheadX + right * aheadY;
    y[count++] = network.cameraY(camera) + ahead * aheadY - right * aheadX;
  }

  /** The same as it is now: the others may have it later. */
  SightingReport copy() {
    return copy(targets);
  }

  /** The same with other numbers of its targets, or more numbers than it has targets. */
  SightingReport copy(int[] numbers) {
    SightingReport copy = new SightingReport(named);
    copy.camera = camera;
    copy.view = view;
    copy.step = step;
    copy.count = count;
    copy.targets = Arrays.copyOf(numbers, count);
    copy.x = Arrays.copyOf(x, count);
    copy.y = Arrays.copyOf(y, count);
    copy.sizes = Arrays.copyOf(sizes, count);
    return copy;
  }

  /** Its length: the view, or none, and each target with its place and size. */
  int bits(NetworkView network) {
    int ofTarget = (named ? MessageBits.of(network.targets()) : 0) + 3 * MessageBits.REAL;
    return MessageBits.address(network.cameras())
        + MessageBits.of(network.views(camera) + 1L)
        + count * ofTarget;
  }

  private void grow(int length) {
    targets = Arrays.copyOf(targets, length);
    x = Arrays.copyOf(x, length);
    y = Arrays.copyOf(y, length);
    sizes = Arrays.copyOf(sizes, length);
  }

  int camera() {
    return camera;
  }

  /** The view that it looks through; -1 for none. */
  int view() {
    return view;
  }

  /** The step in which it sees all this. */
  long step() {
    return step;
  }

  /** Whether it sees a target. */
  boolean has(int target) {
    boolean has = false;
    for (int i = 0; i < count; i++) {
      has |= targets[i] == target;
    }
    return has;
  }

  /** How many targets it sees. */
  int count() {
    return count;
  }

  int target(int i) {
    return targets[i];
  }

  /** Where a target is, metres. */
  double x(int i) {
    return x[i];
  }

  double y(int i) {
    return y[i];
  }

  /** Metres; NaN where it is not known. */
  double size(int i) {
    return sizes[i];
  }
}
