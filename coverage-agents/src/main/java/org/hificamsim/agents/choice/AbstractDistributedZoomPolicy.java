package org.hificamsim.agents.choice;

import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * A policy without a centre: each online camera chooses its own next view.
 *
 * <p>If moves take time, a camera chooses after it has arrived, not during a move (ADR 28).
 */
public abstract class AbstractDistributedZoomPolicy implements ZoomPolicy {
  /**
   * Returns one generator for each camera, so that no camera's draws depend on which others are
   * online or on the order in which they decide.
   */
  protected static SplittableRandom[] split(NetworkView network, SplittableRandom random) {
    return Stream.generate(random::split).limit(network.cameras()).toArray(SplittableRandom[]::new);
  }

  /** Returns the next view of an online camera that is not moving. */
  protected abstract int choose(NetworkView network, int camera);

  /** Called instead of {@link #choose} for a moving camera: returns the view that it moves to. */
  protected int travel(NetworkView network, int camera) {
    return network.view(camera);
  }

  /** Called instead of {@link #choose} for a camera that is offline. */
  protected void skip(int camera) {}

  @Override
  public void decide(NetworkView network, int[] views) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (!network.online(camera)) {
        skip(camera);
      } else if (network.moving(camera)) {
        views[camera] = travel(network, camera);
      } else {
        views[camera] = choose(network, camera);
      }
    }
  }
}
