package org.hificamsim.solver.way;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;

/**
 * The times that a camera needs to move between any two of its views.
 *
 * @param home the view in which it starts
 * @param views number of views
 * @param blindSteps the steps in which the camera sees nothing, by {@code from * views + to}
 */
public record TravelTimes(int home, int views, int[] blindSteps) {
  /** Returns the times of a camera, which starts in the view that it has now. */
  public static TravelTimes of(NetworkView network, int camera) {
    int views = network.views(camera);
    int[] blindSteps = new int[views * views];
    Arrays.setAll(blindSteps, pair -> network.stepsBetween(camera, pair / views, pair % views));
    return new TravelTimes(network.view(camera), views, blindSteps);
  }

  /** Whether these are still the travel times of a camera. */
  public boolean matches(NetworkView network, int camera) {
    boolean same = network.views(camera) == views;
    for (int pair = 0; same && pair < blindSteps.length; pair++) {
      same = network.stepsBetween(camera, pair / views, pair % views) == blindSteps[pair];
    }
    return same;
  }

  /** The number of steps in which the camera sees nothing between two views. */
  public int blindSteps(int from, int to) {
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
