package org.hificamsim.presentation.view;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import org.hificamsim.presentation.replay.Setup;

/**
 * The last steps, as many as there is room for: when it is full, every other one is left out, so
 * that the shape of a curve stays. The last step is always there, and no move is lost.
 */
final class StepBuffer {
  private static final int MAX_STEPS = 4000;
  private static final int MIN_STEPS = 50;
  private static final long MAX_NUMBERS = 1 << 21;

  private final int most;
  private List<LiveStep> steps = new ArrayList<>();

  /**
   * @param most steps, 2 or more
   */
  StepBuffer(int most) {
    this.most = most;
  }

  /** How many steps of a scenario are kept, so that a large one needs no more memory. */
  static int most(Setup setup) {
    long numbers = Math.max(1, setup.numbersPerFrame());
    return (int) Math.max(MIN_STEPS, Math.min(MAX_STEPS, MAX_NUMBERS / numbers));
  }

  void add(LiveStep step) {
    steps.add(step);
    if (steps.size() > most) {
      thin();
    }
  }

  private void thin() {
    List<LiveStep> kept = new ArrayList<>();
    boolean keeps = steps.size() % 2 != 0;
    LiveStep left = null;
    for (LiveStep step : steps) {
      LiveStep whole = left == null ? step : step.after(left);
      left = keeps ? null : whole;
      if (keeps) {
        kept.add(whole);
      }
      keeps = !keeps;
    }
    steps = kept;
  }

  void clear() {
    steps = new ArrayList<>();
  }

  void replaceAll(UnaryOperator<LiveStep> change) {
    steps.replaceAll(change);
  }

  boolean isEmpty() {
    return steps.isEmpty();
  }

  /** The steps, which are then no longer here. */
  List<LiveStep> drain() {
    List<LiveStep> all = steps;
    clear();
    return all;
  }

  /** The steps, in order. */
  List<LiveStep> all() {
    return List.copyOf(steps);
  }
}
