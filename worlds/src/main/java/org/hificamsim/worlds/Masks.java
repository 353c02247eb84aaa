package org.hificamsim.worlds;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.hificamsim.core.policy.NetworkView;

/**
 * Which actions each camera may be given: 1 for each allowed choice of each number of its action. A
 * camera on its way may only go on; one that is off may be given any action of its own: none
 * counts.
 */
public final class Masks {
  private final ActionKind kind;
  private final int width;
  private final byte[] masks;

  /** Of a network whose cameras are given such actions. */
  public Masks(NetworkView network, ActionKind kind) {
    this.kind = kind;
    this.width = width(network, kind);
    this.masks = new byte[width * network.cameras()];
  }

  /** How many choices a camera has, over all numbers of its action. */
  public static int width(NetworkView network, ActionKind kind) {
    return IntStream.of(kind.masked(network)).sum();
  }

  /** The masks of all cameras where the network is before a decision. */
  public byte[] of(NetworkView network) {
    Arrays.fill(masks, (byte) 0);
    for (int camera = 0; camera < network.cameras(); camera++) {
      int from = camera * width;
      if (kind == ActionKind.RATES) {
        Arrays.fill(masks, from, from + width, (byte) 1);
      } else if (network.online(camera) && network.moving(camera)) {
        kind.maskOnItsWay(network, camera, masks, from);
      } else {
        kind.mask(network, camera, masks, from, from + width);
      }
    }
    return masks;
  }
}
