package org.hificamsim.bridge.camsim;

import java.util.List;
import org.hificamsim.core.InputException;

/**
 * Aims CamSim's cameras. Whether {@code change} takes degrees or radians is found out from what it
 * does: the first camera is aimed in each unit until it looks as asked.
 */
public final class Aiming {
  private final CamSim camsim;
  private List<AngleUnit> units = List.of(AngleUnit.values());

  /** The cameras of one CamSim. */
  public Aiming(CamSim camsim) {
    this.camsim = camsim;
  }

  /**
   * Aims a camera as a {@code change} event does.
   *
   * @param wanted with an angle above 0
   * @return how CamSim has it now, which may be rounded or have made a full turn
   * @throws InputException when this CamSim turns cameras otherwise; the camera then looks as it
   *     did, as far as it can be made to
   */
  public Aim aim(Object camera, Aim wanted) {
    Aim before = camsim.aim(camera);
    if (!turns(camera, wanted)) {
      Aim now = camsim.aim(camera);
      turns(camera, before);
      throw InputException.of(
          "CamSim has heading %s and angle %s (radians) after a change to %s and %s,"
              + " expected the same",
          now.heading(), now.angle(), wanted.heading(), wanted.angle());
    }
    return camsim.aim(camera);
  }

  /** Tries the units that may be CamSim's, and remembers the one that is. */
  private boolean turns(Object camera, Aim wanted) {
    for (AngleUnit unit : units) {
      camsim.change(
          camera, unit.heading(wanted.heading()), unit.of(wanted.angle()), wanted.range());
      if (camsim.aim(camera).isNear(wanted)) {
        units = List.of(unit);
        return true;
      }
    }
    return false;
  }
}
