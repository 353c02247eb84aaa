package org.hificamsim.bridge.run;

import java.util.Optional;
import java.util.SplittableRandom;
import org.hificamsim.bridge.agent.FaultLine;
import org.hificamsim.core.Texts;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.runs.Proof;
import org.hificamsim.runs.Traffic;

/**
 * A zoom policy that chooses the views of CamSim's cameras.
 *
 * <p>Policies size their tables when they begin. Where events bring more cameras or targets than
 * were expected then, the policy starts over and has to learn again, which is reported.
 */
final class Steering {
  private final BridgeSettings.Policy given;
  private final long seed;
  private ZoomPolicy policy;
  private int[] views;
  private Traffic earlier = Traffic.NONE;
  private Proof earlierProof = Proof.OF_NOTHING;

  Steering(BridgeSettings.Policy given, long seed) {
    this.given = given;
    this.seed = seed;
  }

  /**
   * All cameras decide from the same snapshot, then all cameras turn to their views.
   *
   * @throws org.hificamsim.core.InputException when the policy does not suit the cameras
   */
  void decide(LiveNetwork network) {
    if (policy == null || network.outgrown()) {
      begin(network);
    }
    for (int camera = 0; camera < views.length; camera++) {
      views[camera] = network.view(camera);
    }
    policy.decide(network, views);
    for (int camera = 0; camera < views.length; camera++) {
      if (network.online(camera)) {
        network.turnTo(camera, checked(network, camera));
      }
    }
  }

  /** Rewards the policy for what the cameras saw. */
  void learn(LiveNetwork network) {
    policy.learn(network);
  }

  /** What the cameras have sent each other for the policy's sake. */
  Traffic traffic() {
    return policy == null
        ? earlier
        : earlier.plus(new Traffic(policy.messages(), policy.bits(), Double.NaN));
  }

  /** What the policy proved; empty for one that does not claim to be the best. */
  Optional<Proof> proof() {
    return Optional.ofNullable(policy).flatMap(Proof::of).map(earlierProof::plus);
  }

  private void begin(LiveNetwork network) {
    if (policy != null) {
      FaultLine.note(
          Texts.format(
              "step %s: more cameras or objects than expected: policy %s starts over",
              network.step(), given.spec()));
    }
    if (network.outgrown()) {
      network.makeRoom();
    }
    earlier = traffic();
    earlierProof = proof().orElse(earlierProof);
    policy = given.maker().get();
    policy.begin(network, new SplittableRandom(seed));
    views = new int[network.cameras()];
  }

  private int checked(LiveNetwork network, int camera) {
    if (views[camera] < 0 || views[camera] >= network.views(camera)) {
      throw new IllegalStateException(
          Texts.format(
              "policy %s chose view %s for camera %s, expected 0 to %s",
              given.spec(), views[camera], network.cameraName(camera), network.views(camera) - 1));
    }
    return views[camera];
  }
}
