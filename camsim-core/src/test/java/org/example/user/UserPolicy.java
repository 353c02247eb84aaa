package org.example.user;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;

/** Keeps all cameras at one level. */
public final class UserPolicy implements ZoomPolicy {
  private int level;

  @Override
  public String name() {
    return "user-level";
  }

  @Override
  public void configure(Options options) {
    level = options.integer("level", 0, 0, 9, "the level");
  }

  @Override
  public void decide(NetworkView network, int[] levels) {
    Arrays.fill(levels, level);
  }
}
