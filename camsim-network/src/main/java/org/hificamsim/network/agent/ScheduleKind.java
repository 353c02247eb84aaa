package org.hificamsim.network.agent;

import java.util.List;

/** The auction schedules of CamSim (behaviour 3.7). */
public enum ScheduleKind implements Named {
  ACTIVE("Active", "epics.ai.auctionSchedules.ActiveAuctionSchedule", "epics.ai.ActiveAINodeMulti"),
  PASSIVE(
      "Passive", "epics.ai.auctionSchedules.PassiveAuctionSchedule", "epics.ai.PassiveAINodeMulti"),
  HISTORICAL_ACTIVE(
      "HistActive",
      "epics.ai.auctionSchedules.HistoricalAINode$Active",
      "epics.ai.HistoricalAINode$Active",
      "epics.ai.HistoricalUnweightedAINodeMulti"),
  HISTORICAL_PASSIVE(
      "HistPassive",
      "epics.ai.auctionSchedules.HistoricalAINode$Passive",
      "epics.ai.HistoricalAINode$Passive"),
  BANDIT_ZOOM(
      "BanditZoom",
      "epics.ai.dynamicZoom.BanditSolverZoom",
      "epics.ai.dynamicZoom.NewActiveBCBanditRange");

  @SuppressWarnings("ImmutableEnumChecker") // nothing changes it
  private final List<String> names;

  ScheduleKind(String... names) {
    this.names = List.of(names);
  }

  @Override
  public List<String> names() {
    return names;
  }

  /** The canonical name of the current class, as in scenarios that CamSim saves. */
  String canonicalName() {
    return names.get(1).replace('$', '.');
  }

  /** Returns whether owned targets are advertised in every step. */
  public boolean isActive() {
    return this != PASSIVE && this != HISTORICAL_PASSIVE;
  }

  /** Returns whether bids depend on how long targets have stayed in view. */
  public boolean isHistorical() {
    return this == HISTORICAL_ACTIVE || this == HISTORICAL_PASSIVE;
  }
}
