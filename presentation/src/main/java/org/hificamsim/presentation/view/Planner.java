package org.hificamsim.presentation.view;

import java.util.List;
import java.util.Optional;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;

/** Says how much of a site its cameras could see, and where one would see more. */
public interface Planner {
  /** The share of a zone's demand that is met, in [0, 1]. */
  record Share(String zone, double met) {}

  /**
   * What the cameras can see of each zone, in some view of theirs.
   *
   * @param detection where a zone has none of its own
   * @throws org.hificamsim.core.InputException where places are seen by chance
   */
  List<Share> shares(Scenario site, Detection detection);

  /**
   * A camera that sees the most that others do not, found in a second or two.
   *
   * @param moved one of the site, which is returned elsewhere; empty for one more
   * @throws org.hificamsim.core.InputException where none sees more, or the camera has no lens
   */
  CameraSpec suggest(Scenario site, Detection detection, Optional<CameraSpec> moved);
}
