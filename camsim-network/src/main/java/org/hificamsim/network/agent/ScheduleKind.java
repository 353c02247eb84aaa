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

  /** The current class's canonical name, as CamSim's saved scenarios have it. */
  String canonicalName() {
    return names.get(1).replace('$', '.');
  }

  /** Whether targets are advertised in every step. */
  public boolean isActive() {
    return this != PASSIVE && this != HISTORICAL_PASSIVE;
  }

  /** Whether bids weigh how long targets used to stay in view. */
  public boolean isHistorical() {
    return this == HISTORICAL_ACTIVE || this == HISTORICAL_PASSIVE;
  }
}
