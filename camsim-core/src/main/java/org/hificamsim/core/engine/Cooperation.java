package org.hificamsim.core.engine;

import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.visibility.Visibility;

/**
 * The joint actions of the cameras of a network in a step, such as failing, looking, trading and
 * handing over targets.
 */
public interface Cooperation {
  /** The cooperation without joint actions. */
  Cooperation NONE = new Cooperation() {};

  /**
   * The rules by which cameras see with a detection model; called once, before {@link #begin}.
   *
   * @param seed the seed of the run
   */
  default Visibility visibility(Detection detection, long seed) {
    return Visibility.of(detection, seed);
  }

  /** Called once, before the first step. */
  default void begin(OracleView network) {}

  /** Called before the cameras decide and observe, after targets moved in CamSim's order. */
  default void prepare() {}

  /**
   * Lets all online cameras look at the targets. Cameras that do not look by themselves call {@link
   * Observation#look}.
   *
   * @param observation receives what each camera detects
   */
  default void observe(Observation observation) {
    observation.look();
  }

  /** Called after the observation. */
  default void cooperate() {}

  /** The sums of the joint actions so far. */
  default NetworkSums sums() {
    return NetworkSums.NONE;
  }
}
