package org.hificamsim.core.engine;

/**
 * The phases of a simulation's steps for callers that stop within a step, such as an environment
 * that waits for actions before {@link StepPhase#DECIDE}. It knows which phase comes next, so that
 * no phase is left out or run twice.
 */
public final class StepPhases {
  private static final StepPhase[] ORDER = StepPhase.values();

  private final Simulation simulation;
  private int nextIndex;

  StepPhases(Simulation simulation) {
    this.simulation = simulation;
  }

  /** The phase that runs next. */
  public StepPhase next() {
    return ORDER[nextIndex];
  }

  /** Runs phases until the given one comes next; none if it does already. */
  public void runUntil(StepPhase stop) {
    while (next() != stop) {
      runNext();
    }
  }

  /** Runs the remaining phases of the step that is under way, or a whole step if none is. */
  public void finishStep() {
    do {
      runNext();
    } while (nextIndex != 0);
  }

  private void runNext() {
    switch (next()) {
      case FIRE_EVENTS -> simulation.fireEvents();
      case MOVE_BEFORE_LOOKING -> simulation.moveBeforeLooking();
      case DECIDE -> simulation.decide();
      case OBSERVE -> simulation.observe();
      case COOPERATE -> simulation.cooperate();
      case LEARN -> simulation.learn();
      case MEASURE -> simulation.measure();
      case REPORT -> simulation.report();
      case MOVE_AFTER_LOOKING -> simulation.moveAfterLooking();
    }
    nextIndex = (nextIndex + 1) % ORDER.length;
  }

  /**
   * Checks that no step is under way.
   *
   * @throws IllegalStateException if one is
   */
  void requireWholeStep() {
    if (nextIndex != 0) {
      throw new IllegalStateException(
          "a step is under way, its next phase is " + next() + ": expected phases().finishStep()");
    }
  }
}
