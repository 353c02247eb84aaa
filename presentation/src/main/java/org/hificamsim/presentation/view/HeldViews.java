package org.hificamsim.presentation.view;

import java.util.Map;
import java.util.SplittableRandom;
import org.hificamsim.core.policy.BeliefListener;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.OraclePolicy;
import org.hificamsim.core.policy.ZoomPolicy;

/** A policy that chooses views for all cameras except those that a user holds in a view. */
final class HeldViews implements ZoomPolicy {
  private final ZoomPolicy policy;
  private final Map<String, Integer> held;

  private HeldViews(ZoomPolicy policy, Map<String, Integer> held) {
    this.policy = policy;
    this.held = held;
  }

  /**
   * Returns a policy by which cameras are held in their views.
   *
   * @param held the view of each camera by its name; it may change between steps
   */
  static ZoomPolicy hold(ZoomPolicy policy, Map<String, Integer> held) {
    return OraclePolicy.wrapping(policy, new HeldViews(policy, held));
  }

  @Override
  public String name() {
    return policy.name();
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    policy.begin(network, random);
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    policy.decide(network, views);
    for (int camera = 0; camera < views.length && !held.isEmpty(); camera++) {
      views[camera] = held.getOrDefault(network.cameraName(camera), views[camera]);
    }
  }

  @Override
  public boolean jumps() {
    return policy.jumps();
  }

  @Override
  public void learn(NetworkView network) {
    policy.learn(network);
  }

  @Override
  public String estimates(int camera, double[] estimates, double[] counts) {
    return policy.estimates(camera, estimates, counts);
  }

  @Override
  public boolean believe(int camera, BeliefListener listener) {
    return policy.believe(camera, listener);
  }

  @Override
  public long messages() {
    return policy.messages();
  }

  @Override
  public long bits() {
    return policy.bits();
  }
}
