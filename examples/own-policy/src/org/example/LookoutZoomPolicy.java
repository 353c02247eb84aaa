package org.example;

import java.util.SplittableRandom;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;

/**
 * A policy of one's own: each camera sweeps through its zoom views, and stays for a while on a view
 * at which it detected something.
 */
public final class LookoutZoomPolicy implements ZoomPolicy {
  private int patience;
  private int[] waited;

  @Override
  public String name() {
    return "lookout";
  }

  @Override
  public void configure(Options options) {
    patience = options.integer("patience", 10, 1, 1000, "steps to stay where a target was seen");
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    waited = new int[network.cameras()];
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      boolean stays = network.detected(camera) > 0 && waited[camera] < patience;
      waited[camera] = stays ? waited[camera] + 1 : 0;
      if (!stays) {
        views[camera] = (network.view(camera) + 1) % network.views(camera);
      }
    }
  }
}
