package org.hificamsim.core.scenario.spec;

import org.hificamsim.core.InputException;

/**
 * Checks the attributes that a camera has for CamSim's network; the scenario does not read them.
 */
@FunctionalInterface
public interface AgentCheck {
  /** The check that accepts everything. */
  AgentCheck NONE = (camera, added, fault) -> {};

  /** Makes the error about an attribute of the camera. */
  @FunctionalInterface
  interface Fault {
    /** The error, which names the attribute's place and value. */
    InputException in(String attribute, String expected);
  }

  /**
   * Checks the next camera: those of the file, then those that events add, in their order.
   *
   * @param added whether an event adds it
   * @throws InputException made by {@code fault}
   */
  void check(CameraSpec camera, boolean added, Fault fault);
}
