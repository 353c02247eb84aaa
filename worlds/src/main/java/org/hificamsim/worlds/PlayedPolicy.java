package org.hificamsim.worlds;

import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/** Carries out the actions of a step that it is given, one camera after the other. */
public final class PlayedPolicy implements ZoomPolicy {
  private final ActionKind kind;
  private int[] actions = {};

  public PlayedPolicy(ActionKind kind) {
    this.kind = kind;
  }

  /**
   * What to do next.
   *
   * @param newActions read at the next decision
   */
  public void play(int[] newActions) {
    actions = newActions;
  }

  @Override
  public String name() {
    return "played";
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    for (int camera = 0; camera < views.length; camera++) {
      if (network.online(camera) && !network.moving(camera)) {
        views[camera] = kind.view(network, camera, actions, camera * kind.numbers());
      }
    }
  }
}
