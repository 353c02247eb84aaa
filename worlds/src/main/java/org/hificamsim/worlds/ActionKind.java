package org.hificamsim.worlds;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;

/**
 * The encoding of actions. A camera that is moving continues whatever its action is, and so does a
 * camera whose mask forbids its action.
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
    int view(NetworkView network, int camera, int[] actions, int offset, Steering steering) {
      return actions[offset] < network.views(camera) ? actions[offset] : network.view(camera);
    }

    @Override
    void mask(NetworkView network, int camera, byte[] out, int from, int to) {
      Arrays.fill(out, from, Math.min(to, from + network.views(camera)), (byte) 1);
    }

    @Override
    void maskMoving(NetworkView network, int camera, byte[] out, int from) {
      out[from + network.view(camera)] = 1;
    }
  },

  /**
   * Two numbers, 0 to 2: one pan angle to the left, none, or to the right; one zoom level narrower,
   * none, or wider.
   */
  STEPS(2) {
    @Override
    public int[] choices(NetworkView network) {
      return new int[] {3, 3};
    }

    @Override
    int view(NetworkView network, int camera, int[] actions, int offset, Steering steering) {
      int pan = network.panOf(camera, network.view(camera));
      int zoom = network.zoomOf(camera, network.view(camera));
      return network.viewAt(
          camera,
          moved(pan, actions[offset] - 1, network.pans(camera)),
          moved(zoom, actions[offset + 1] - 1, network.zooms(camera)));
    }

    @Override
    void mask(NetworkView network, int camera, byte[] out, int from, int to) {
      for (int step = 0; step < 3; step++) {
        int pan = network.panOf(camera, network.view(camera)) + step - 1;
        int zoom = network.zoomOf(camera, network.view(camera)) + step - 1;
        out[from + step] = (byte) (isInRange(network.pans(camera), pan) ? 1 : 0);
        out[from + 3 + step] = (byte) (isInRange(network.zooms(camera), zoom) ? 1 : 0);
      }
    }

    @Override
    void maskMoving(NetworkView network, int camera, byte[] out, int from) {
      out[from + 1] = 1;
      out[from + 4] = 1;
    }
  },

  /**
   * Two numbers, 0 to 2000: the speeds of turning and zooming, in thousandths of the speed of the
   * drives less 1000; 0 is to the left or narrower, and 1000 stops. Moving cameras are steered too.
   */
  RATES(2) {
    private static final int FULL_SPEED = 1000;

    @Override
    public int[] choices(NetworkView network) {
      return new int[] {2 * FULL_SPEED + 1, 2 * FULL_SPEED + 1};
    }

    @Override
    int[] maskWidths(NetworkView network) {
      return new int[] {1, 1};
    }

    @Override
    int view(NetworkView network, int camera, int[] actions, int offset, Steering steering) {
      return steering.move(network, camera, rate(actions[offset]), rate(actions[offset + 1]));
    }

    private static double rate(int action) {
      return (double) (action - FULL_SPEED) / FULL_SPEED;
    }
  };

  private final int numbers;

  ActionKind(int numbers) {
    this.numbers = numbers;
  }

  private static boolean isInRange(int count, int number) {
    return number >= 0 && number < count;
  }

  /** Returns the number after a move, or the same number if the move leads out of range. */
  private static int moved(int number, int change, int count) {
    return isInRange(count, number + change) ? number + change : number;
  }

  /** The length of an action: how many numbers it consists of. */
  public int numbers() {
    return numbers;
  }

  /** The number of choices for each number of an action, the same for all cameras. */
  public abstract int[] choices(NetworkView network);

  /** The number of mask entries for each number of an action: its choices, except for rates. */
  int[] maskWidths(NetworkView network) {
    return choices(network);
  }

  /**
   * Returns the view that an action selects for a camera.
   *
   * @param offset the index of the camera's action in {@code actions}
   */
  abstract int view(NetworkView network, int camera, int[] actions, int offset, Steering steering);

  /**
   * Writes 1 for the allowed actions of a camera that is not moving; not called for rates.
   *
   * @param out receives the masks, which are 0 before
   */
  void mask(NetworkView network, int camera, byte[] out, int from, int to) {}

  /** Writes 1 for the action by which a moving camera continues; not called for rates. */
  void maskMoving(NetworkView network, int camera, byte[] out, int from) {}
}
