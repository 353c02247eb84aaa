package org.hificamsim.worlds;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;

/**
 * How an action says what a camera is to do. A camera that is on its way goes on, whatever its
 * action says, and so does one whose action its mask forbids.
 */
public enum ActionKind {
  /** The number of a view. */
  VIEW(1) {
    @Override
    public int[] choices(NetworkView network) {
      int most = 1;
      for (int camera = 0; camera < network.cameras(); camera++) {
        most = Math.max(most, network.views(camera));
      }
      return new int[] {most};
    }

    @Override
    int view(NetworkView network, int camera, int[] actions, int at, Steering steering) {
      return actions[at] < network.views(camera) ? actions[at] : network.view(camera);
    }

    @Override
    void mask(NetworkView network, int camera, byte[] out, int from, int to) {
      Arrays.fill(out, from, Math.min(to, from + network.views(camera)), (byte) 1);
    }

    @Override
    void maskOnItsWay(NetworkView network, int camera, byte[] out, int from) {
      out[from + network.view(camera)] = 1;
    }
  },

  /** Two numbers, 0 to 2: one pan angle to the left, none, to the right; narrower, as is, wider. */
  STEPS(2) {
    @Override
    public int[] choices(NetworkView network) {
      return new int[] {3, 3};
    }

    @Override
    int view(NetworkView network, int camera, int[] actions, int at, Steering steering) {
      int pan = network.panOf(camera, network.view(camera));
      int zoom = network.zoomOf(camera, network.view(camera));
      return network.viewAt(
          camera,
          moved(pan, actions[at] - 1, network.pans(camera)),
          moved(zoom, actions[at + 1] - 1, network.zooms(camera)));
    }

    @Override
    void mask(NetworkView network, int camera, byte[] out, int from, int to) {
      for (int step = 0; step < 3; step++) {
        int pan = network.panOf(camera, network.view(camera)) + step - 1;
        int zoom = network.zoomOf(camera, network.view(camera)) + step - 1;
        out[from + step] = (byte) (isOneOf(network.pans(camera), pan) ? 1 : 0);
        out[from + 3 + step] = (byte) (isOneOf(network.zooms(camera), zoom) ? 1 : 0);
      }
    }

    @Override
    void maskOnItsWay(NetworkView network, int camera, byte[] out, int from) {
      out[from + 1] = 1;
      out[from + 4] = 1;
    }
  },

  /**
   * Two numbers, 0 to 2000: how fast it turns and zooms, in thousandths of its drives' speed, 0 to
   * the left or narrower, 1000 not at all. A camera on its way is steered too.
   */
  RATES(2) {
    private static final int WHOLE = 1000;

    @Override
    public int[] choices(NetworkView network) {
      return new int[] {2 * WHOLE + 1, 2 * WHOLE + 1};
    }

    @Override
    int[] masked(NetworkView network) {
      return new int[] {1, 1};
    }

    @Override
    int view(NetworkView network, int camera, int[] actions, int at, Steering steering) {
      return steering.moved(network, camera, rate(actions[at]), rate(actions[at + 1]));
    }

    private static double rate(int action) {
      return (double) (action - WHOLE) / WHOLE;
    }
  };

  private final int numbers;

  ActionKind(int numbers) {
    this.numbers = numbers;
  }

  private static boolean isOneOf(int count, int number) {
    return number >= 0 && number < count;
  }

  /** The number after a move, the same where the move leads nowhere. */
  private static int moved(int number, int by, int count) {
    return isOneOf(count, number + by) ? number + by : number;
  }

  /** How many numbers an action has. */
  public int numbers() {
    return numbers;
  }

  /** Of how many each number of an action is one, counted from 0; the same for all cameras. */
  public abstract int[] choices(NetworkView network);

  /** Of how many each number has a mask: but for rates, which nothing forbids, of all. */
  int[] masked(NetworkView network) {
    return choices(network);
  }

  /** The view that an action sends a camera to. */
  abstract int view(NetworkView network, int camera, int[] actions, int at, Steering steering);

  /** Writes 1, over zeros, for the actions of a camera that has arrived, but for rates. */
  void mask(NetworkView network, int camera, byte[] out, int from, int to) {}

  /** Writes 1 for what says that a camera goes on, but for rates. */
  void maskOnItsWay(NetworkView network, int camera, byte[] out, int from) {}
}
