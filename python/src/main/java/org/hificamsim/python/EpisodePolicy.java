package org.hificamsim.python;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.hificamsim.worlds.ActionKind;
import org.hificamsim.worlds.PlayedPolicy;

/**
 * Replays the actions of an episode: {@code played:actions=view,file=FILE}. The file has one
 * little-endian int of four bytes for each number of each action, step by step.
 */
public final class EpisodePolicy implements ZoomPolicy {
  private ActionKind kind = ActionKind.VIEW;
  private String file = "";
  private PlayedPolicy policy;
  private ByteBuffer remainingActions;
  private int[] actions;

  @Override
  public String name() {
    return "played";
  }

  @Override
  public void configure(Options options) {
    kind = options.choice("actions", ActionKind.VIEW, "what an action is: view, steps, rates");
    file = options.text("file", "", "the actions of all steps");
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    if (policy == null) {
      begin(network);
    }
    if (remainingActions.remaining() < Integer.BYTES * actions.length) {
      throw InputException.of(
          "%s has no action for step %s, expected one for every step", file, network.step());
    }
    for (int i = 0; i < actions.length; i++) {
      actions[i] = remainingActions.getInt();
    }
    policy.play(actions);
    policy.decide(network, views);
  }

  private void begin(NetworkView network) {
    try {
      remainingActions =
          ByteBuffer.wrap(Files.readAllBytes(Path.of(file))).order(ByteOrder.LITTLE_ENDIAN);
    } catch (IOException e) {
      throw new InputException(file + " cannot be read, expected the actions of an episode", e);
    }
    policy = new PlayedPolicy(kind);
    actions = new int[network.cameras() * kind.numbers()];
  }
}
