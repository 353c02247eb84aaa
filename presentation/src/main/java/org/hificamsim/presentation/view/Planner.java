package org.hificamsim.presentation.view;

import java.util.List;
import java.util.Optional;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;

/**
 * Computes how much of a scenario its cameras can see, suggests cameras that see more, and plans
 * all of them.
 */
public interface Planner {
  /** The share of a zone's demand that is met, in [0, 1]. */
  record Share(String zone, double met) {}

  /** The goal of a plan. */
  enum Goal {
    /** The most that a number of cameras can meet. */
    CAMERAS,
    /** The most for a price. */
    BUDGET,
    /** Everything that can be met, for the least price. */
    COVER
  }

  /**
   * The request for a plan.
   *
   * @param amount the number of cameras or the budget; not used to cover everything
   * @param keep whether the cameras that are there stay
   * @param ceiling whether cameras may hang anywhere on the ceiling, at the height of all cameras
   */
  record Request(Goal goal, double amount, boolean keep, boolean ceiling) {}

  /**
   * A plan of cameras for a site.
   *
   * @param cameras those that stay first
   * @param claim the share that they meet, in words
   * @param facts the facts that say more, such as the bound
   */
  record Plan(List<CameraSpec> cameras, String claim, List<String> facts) {}

  /** Receives the progress of a plan, and may end the search. */
  interface Watcher {
    /**
     * @param event what happens, in words
     * @param share the share of the work that is done, in [0, 1]
     */
    void progressed(String event, double share);

    /** Whether the user has ended the search: the best plan so far is taken, if there is one. */
    boolean isStopped();
  }

  /**
   * Returns the share of each zone that the cameras can see, each in any of its views.
   *
   * @param detection the detection of zones that have none of their own
   * @throws org.hificamsim.core.InputException if detection is by chance
   */
  List<Share> shares(Scenario scenario, Detection detection);

  /**
   * Returns a camera at the place where it sees the most that others do not see. Takes a second or
   * two.
   *
   * @param moved the camera to be moved; empty for a new camera
   * @throws org.hificamsim.core.InputException if no place is better, or the camera has no lens
   */
  CameraSpec suggest(Scenario scenario, Detection detection, Optional<CameraSpec> moved);

  /** The names of the cameras that can be bought. */
  List<String> kinds();

  /**
   * A camera that a user mounts.
   *
   * @param kind its name
   * @param heading the heading in degrees
   * @param angle the angle of view to which its lens is set, in degrees; null for the widest
   */
  record Mount(String kind, double x, double y, double heading, Double angle) {}

  /**
   * Returns a camera that can be bought, at its price. Its lens stays as it is set, unless it
   * turns.
   *
   * @throws org.hificamsim.core.InputException if there is no such kind, or its lens has no such
   *     angle
   */
  CameraSpec mounted(Mount mount, Scenario scenario);

  /**
   * Returns the best cameras for a site that are found in a minute or two.
   *
   * @throws org.hificamsim.core.InputException if a zone is seen from nowhere, the request is
   *     wrong, or the search is stopped before there is a plan
   */
  Plan plan(Scenario scenario, Detection detection, Request request, Watcher watcher);
}
