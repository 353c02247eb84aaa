package org.hificamsim.network;

import java.util.List;
import org.hificamsim.network.agent.Named;

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

  private final String shortName;
  private final String classNames;

  ScheduleKind(String shortName, String... classNames) {
    this.shortName = shortName;
    this.classNames = String.join(" ", classNames);
  }

  @Override
  public String shortName() {
    return shortName;
  }

  @Override
  public List<String> classNames() {
    return List.of(classNames.split(" "));
  }

  /** The current class's canonical name, as CamSim's saved scenarios have it. */
  public String canonicalName() {
    return classNames().get(0).replace('$', '.');
  }

  /** Whether targets are advertised in every step. */
  public boolean isActive() {
    return this != PASSIVE && this != HISTORICAL_PASSIVE;
  }

  public boolean isHistorical() {
    return this == HISTORICAL_ACTIVE || this == HISTORICAL_PASSIVE;
  }
}
