package org.hificamsim.worlds;

import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * The actions of an episode so far. Together with the seed they determine everything else, so an
 * episode is saved as its history and restored by replaying it.
 */
final class EpisodeHistory {
  private static final int FIRST_CAPACITY = 256;

  private short[] actions = new short[FIRST_CAPACITY];
  private int length;

  /** Forgets all actions. */
  void clear() {
    length = 0;
  }

  /** Adds the actions of a step, which must fit 16 bits. */
  void add(int[] stepActions) {
    if (length + stepActions.length > actions.length) {
      actions = Arrays.copyOf(actions, Math.max(2 * actions.length, length + stepActions.length));
    }
    for (int action : stepActions) {
      actions[length++] = (short) action;
    }
  }

  /** The number of bytes that {@link #writeTo} writes. */
  int bytes() {
    return Integer.BYTES + Short.BYTES * length;
  }

  /** Writes the number of actions as 4 bytes, and each action as 2 bytes, big-endian. */
  void writeTo(ByteBuffer out) {
    out.putInt(length);
    out.asShortBuffer().put(actions, 0, length);
    out.position(out.position() + Short.BYTES * length);
  }

  /**
   * Reads what {@link #writeTo} has written.
   *
   * @throws java.nio.BufferUnderflowException if there are fewer actions than their number says
   */
  static short[] read(ByteBuffer in) {
    int count = in.getInt();
    short[] actions = new short[Math.max(0, Math.min(count, in.remaining() / Short.BYTES + 1))];
    in.asShortBuffer().get(actions);
    in.position(in.position() + Short.BYTES * actions.length);
    return actions;
  }
}
