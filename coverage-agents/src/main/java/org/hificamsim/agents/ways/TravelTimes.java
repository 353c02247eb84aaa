package org.hificamsim.agents.ways;

/**
 * How long a camera is on its way between any two of its views.
 *
 * @param home the view in which it starts
 * @param views how many it has
 * @param blindSteps by {@code from * views + to}: the steps in which it sees nothing
 */
public record TravelTimes(int home, int views, int[] blindSteps) {
  int blindSteps(int from, int to) {
    return blindSteps[from * views + to];
  }

  /** Whether any move takes more than the step in which it begins. */
  public boolean takesTime() {
    for (int steps : blindSteps) {
      if (steps > 0) {
        return true;
      }
    }
    return false;
  }
}
