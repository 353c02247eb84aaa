package org.hificamsim.presentation.replay;

import java.util.Arrays;
import org.hificamsim.core.policy.BeliefListener;
import org.hificamsim.core.scenario.spec.Field;

/**
 * Collects what a camera believes as numbers for a {@link Frame}, in this order:
 *
 * <ol>
 *   <li>for each target: x, y, weight and spread; the weight is 0 for no target
 *   <li>the expected number of unseen targets in each of {@link #PARTS_PER_SIDE} x {@link
 *       #PARTS_PER_SIDE} equal parts of the field, row by row from the south-west
 *   <li>for each camera: the number of messages that it sent in this step
 *   <li>for each camera: the cameras that received them, as bits, {@link #BITS_PER_NUMBER} in each
 *       number
 * </ol>
 */
final class BeliefFrame implements BeliefListener {
  /** The number of parts of the field along each side. */
  static final int PARTS_PER_SIDE = 20;

  static final int NUMBERS_PER_TARGET = 4;
  static final int BITS_PER_NUMBER = 32;

  /** The number of parts of a unit to which all numbers are rounded. */
  static final double PER_UNIT = 1000;

  private final Field field;
  private final int targets;
  private final int cameras;
  private final double[] numbers;
  private int followedCount;

  BeliefFrame(Setup setup) {
    field = setup.field();
    targets = setup.targets().size();
    cameras = setup.cameras().size();
    numbers = new double[length(setup)];
  }

  /** Returns how many numbers a belief has. */
  static int length(Setup setup) {
    int cameras = setup.cameras().size();
    return NUMBERS_PER_TARGET * setup.targets().size()
        + PARTS_PER_SIDE * PARTS_PER_SIDE
        + cameras * (1 + numbersPerSender(cameras));
  }

  private static int numbersPerSender(int cameras) {
    return (cameras + BITS_PER_NUMBER - 1) / BITS_PER_NUMBER;
  }

  @Override
  public void followed(double x, double y, double weight, double spread) {
    if (followedCount < targets) {
      double[] target = {x, y, weight, spread};
      int offset = NUMBERS_PER_TARGET * followedCount++;
      System.arraycopy(target, 0, numbers, offset, NUMBERS_PER_TARGET);
    }
  }

  @Override
  public void unseen(double x, double y, double expected) {
    int column = part((x - field.minX()) / field.width());
    int row = part((y - field.minY()) / field.height());
    numbers[NUMBERS_PER_TARGET * targets + PARTS_PER_SIDE * row + column] += expected;
  }

  @Override
  public void sent(int camera, int messages) {
    numbers[messagesOffset() + camera] = messages;
  }

  @Override
  public void received(int from, int to) {
    int firstOfSender = messagesOffset() + cameras + from * numbersPerSender(cameras);
    numbers[firstOfSender + to / BITS_PER_NUMBER] += 1L << to % BITS_PER_NUMBER;
  }

  private int messagesOffset() {
    return NUMBERS_PER_TARGET * targets + PARTS_PER_SIDE * PARTS_PER_SIDE;
  }

  private static int part(double share) {
    return Math.max(0, Math.min(PARTS_PER_SIDE - 1, (int) (PARTS_PER_SIDE * share)));
  }

  /** Returns all numbers, rounded. */
  double[] numbers() {
    return Arrays.stream(numbers).map(number -> Math.rint(PER_UNIT * number) / PER_UNIT).toArray();
  }
}
