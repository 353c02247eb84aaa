package org.hificamsim.core.engine;

import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.visibility.Visibility;

/**
 * What the cameras of a network do together in a step: failing, looking, talking, handing targets
 * over. The loop's one place for it.
 */
public interface Cooperation {
  /** Every camera works for itself. */
  Cooperation NONE = new Cooperation() {};

  /**
   * How cameras see by a detection model.
   *
   * @param seed of the run
   */
  default Visibility visibility(Detection detection, long seed) {
    return Visibility.of(detection, seed);
  }

  /** Called once, before the first step. */
  default void begin(NetworkView network) {}

  /** Called before the cameras decide and observe, after targets moved in CamSim's order. */
  default void prepare() {}

  /**
   * All online cameras look at the targets, where they do so themselves; {@link #visibility} says
   * what they see.
   *
   * @param detected one entry per camera, receives how many targets it detects, 0 while offline
   * @param coverage one entry per target, receives how many cameras detect it
   * @return whether they did; if not, the loop looks for them
   */
  default boolean observe(int[] detected, int[] coverage) {
    return false;
  }

  /** Called after the observation. */
  default void cooperate() {}

  /** What came of it so far. */
  default NetworkSums sums() {
    return NetworkSums.NONE;
  }
}
