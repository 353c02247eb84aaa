package org.hificamsim.worlds;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.hificamsim.core.policy.NetworkView;

/**
 * Computes the allowed actions of each camera. An action is one or more numbers; each has a mask
 * with an entry for each choice, 1 if it is allowed. A moving camera may only continue. An offline
 * camera may get any of its actions, since none has an effect.
 */
public final class Masks {
  private final ActionKind kind;
  private final int width;
  private final byte[] masks;

  /** Creates the masks of a network whose cameras get actions of a kind. */
  public Masks(NetworkView network, ActionKind kind) {
    this.kind = kind;
    this.width = width(network, kind);
    this.masks = new byte[width * network.cameras()];
  }

  /** The number of mask entries of a camera, over all numbers of its action. */
  public static int width(NetworkView network, ActionKind kind) {
    return IntStream.of(kind.maskWidths(network)).sum();
  }

  /** Returns the masks of all cameras before a decision. */
  public byte[] compute(NetworkView network) {
    Arrays.fill(masks, (byte) 0);
    for (int camera = 0; camera < network.cameras(); camera++) {
      int from = camera * width;
      if (kind == ActionKind.RATES) {
        Arrays.fill(masks, from, from + width, (byte) 1);
      } else if (network.online(camera) && network.moving(camera)) {
        kind.maskMoving(network, camera, masks, from);
      } else {
        kind.mask(network, camera, masks, from, from + width);
      }
    }
    return masks;
  }
}
