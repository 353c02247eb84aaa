package org.hificamsim.network;

import java.util.List;
import org.hificamsim.network.agent.Named;

/** The communication policies of CamSim, in the order of their numbers (behaviour 8.6). */
public enum PolicyKind implements Named {
  BROADCAST("Broadcast"),
  SMOOTH("Smooth"),
  STEP("Step"),
  FIX("Fix");

  private final String shortName;

  PolicyKind(String shortName) {
    this.shortName = shortName;
  }

  @Override
  public String shortName() {
    return shortName;
  }

  @Override
  public List<String> classNames() {
    return List.of("epics.ai.commpolicy." + shortName, "epics.commpolicy." + shortName);
  }
}
