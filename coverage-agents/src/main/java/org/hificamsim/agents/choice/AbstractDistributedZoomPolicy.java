package org.hificamsim.agents.choice;

import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.hificamsim.core.policy.CameraTask;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * A policy without a centre: each online camera chooses its own next view. The run's threads share
 * the cameras.
 *
 * <p>Where moves take time, a camera chooses when it has arrived, and not on its way (ADR 28).
 */
public abstract class AbstractDistributedZoomPolicy implements ZoomPolicy {
  private final CameraTask<int[]> choosing = this::chooseAll;

  /**
   * One generator for each camera, so that no camera's draws depend on which others are online or
   * on the order in which they decide.
   */
  protected static SplittableRandom[] split(NetworkView network, SplittableRandom random) {
    return Stream.generate(random::split).limit(network.cameras()).toArray(SplittableRandom[]::new);
  }

  /**
   * The next view of an online camera that is where it went. It must not read what another camera's
   * choice writes.
   */
  protected abstract int choose(NetworkView network, int camera);

  /** Called instead of {@link #choose} for a camera on its way: the view that it goes on to. */
  protected int travel(NetworkView network, int camera) {
    return network.view(camera);
  }

  /** Called instead of {@link #choose} for a camera that is offline. */
  protected void skip(int camera) {}

  @Override
  public void decide(NetworkView network, int[] views) {
    network.divide(views, choosing);
  }

  /**
   * Fills in the views of the online cameras from {@code from} up to, not including, {@code to}.
   */
  protected void chooseAll(NetworkView network, int[] views, int from, int to) {
    for (int camera = from; camera < to; camera++) {
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
