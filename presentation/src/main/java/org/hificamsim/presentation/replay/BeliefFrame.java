package org.hificamsim.presentation.replay;

import java.util.Arrays;
import org.hificamsim.core.policy.BeliefListener;
import org.hificamsim.core.scenario.spec.Field;

/**
 * What a camera believes, as the numbers of a {@link Frame}: for each target x, y, weight and
 * spread, the weight 0 for none; then the targets expected unseen in each of {@link #SIDE} x {@link
 * #SIDE} equal parts of the field, row by row from its south-west; then for each camera the
 * messages that it sent in this step; then for each the cameras that received them, a number with a
 * bit for each of {@link #WORD} cameras, as many numbers as it takes.
 */
final class BeliefFrame implements BeliefListener {
  /** Parts of the field along each side. */
  static final int SIDE = 20;

  /** Numbers of a target. */
  static final int PER_TARGET = 4;

  /** Cameras in a number. */
  static final int WORD = 32;

  /** Parts of a unit that all are rounded to. */
  static final double PARTS = 1000;

  private final Field field;
  private final int targets;
  private final int cameras;
  private final double[] numbers;
  private int count;

  BeliefFrame(Setup setup) {
    field = setup.field();
    targets = setup.targets().size();
    cameras = setup.cameras().size();
    numbers = new double[length(setup)];
  }

  /** How many numbers a belief has. */
  static int length(Setup setup) {
    int cameras = setup.cameras().size();
    return PER_TARGET * setup.targets().size() + SIDE * SIDE + cameras * (1 + words(cameras));
  }

  private static int words(int cameras) {
    return (cameras + WORD - 1) / WORD;
  }

  @Override
  public void followed(double x, double y, double weight, double spread) {
    if (count < targets) {
      double[] one = {x, y, weight, spread};
      System.arraycopy(one, 0, numbers, PER_TARGET * count++, PER_TARGET);
    }
  }

  @Override
  public void unseen(double x, double y, double expected) {
    int column = part((x - field.minX()) / field.width());
    int row = part((y - field.minY()) / field.height());
    numbers[PER_TARGET * targets + SIDE * row + column] += expected;
  }

  @Override
  public void told(int camera, int messages) {
    numbers[told() + camera] = messages;
  }

  @Override
  public void heard(int from, int to) {
    int word = told() + cameras + from * words(cameras) + to / WORD;
    numbers[word] += 1L << to % WORD;
  }

  private int told() {
    return PER_TARGET * targets + SIDE * SIDE;
  }

  private static int part(double share) {
    return Math.max(0, Math.min(SIDE - 1, (int) (SIDE * share)));
  }

  /** All, rounded. */
  double[] numbers() {
    return Arrays.stream(numbers).map(number -> Math.rint(PARTS * number) / PARTS).toArray();
  }
}
