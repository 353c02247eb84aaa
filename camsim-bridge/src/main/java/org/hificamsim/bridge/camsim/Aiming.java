package org.hificamsim.bridge.camsim;

import java.util.List;
import org.hificamsim.core.InputException;

/**
 * Aims CamSim's cameras. Since versions of CamSim differ in whether {@code change} takes degrees or
 * radians, it tries both with the first camera, and keeps the unit that gives the wanted aim.
 */
public final class Aiming {
  private final CamSim camsim;
  private List<AngleUnit> units = List.of(AngleUnit.values());

  /** Prepares to aim the cameras of one CamSim. */
  public Aiming(CamSim camsim) {
    this.camsim = camsim;
  }

  /**
   * Aims a camera as a {@code change} event does.
   *
   * @param wanted the aim, with an angle above 0
   * @return the aim that CamSim reports, which may be rounded or differ by full turns
   * @throws InputException if this CamSim turns cameras in another way; the camera then gets its
   *     former aim back, if possible
   */
  public Aim aim(Object camera, Aim wanted) {
    Aim before = camsim.aim(camera);
    if (!tryUnits(camera, wanted)) {
      Aim now = camsim.aim(camera);
      tryUnits(camera, before);
      throw InputException.of(
          "CamSim has heading %s and angle %s (radians) after a change to %s and %s,"
              + " expected the same",
          now.heading(), now.angle(), wanted.heading(), wanted.angle());
    }
    return camsim.aim(camera);
  }

  /** Tries the remaining units, and keeps only the one that works. */
  private boolean tryUnits(Object camera, Aim wanted) {
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
