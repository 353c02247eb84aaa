package org.hificamsim.presentation.view;

import java.util.List;
import java.util.Optional;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;

/** Computes how much of a scenario its cameras can see, and suggests cameras that see more. */
public interface Planner {
  /** The share of a zone's demand that is met, in [0, 1]. */
  record Share(String zone, double met) {}

  /**
   * Returns the share of each zone that the cameras can see, each in any of its views.
   *
   * @param detection of zones that have none of their own
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
}
