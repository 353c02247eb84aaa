package org.hificamsim.bench;

import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.network.CamSimScenario;
import org.hificamsim.network.NetworkRun;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.network.Strategy;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.runs.RunPlan;

/** Starts runs of CamSim's network in our engine. */
public final class AuctionRun {
  private AuctionRun() {}

  /**
   * Returns a run with CamSim's order and visibility, and seed 0.
   *
   * @param communicationPolicy the number of the communication policy: 0 is Broadcast
   */
  public static NetworkRun of(Scenario scenario, ScheduleKind schedule, int communicationPolicy) {
    Catalogue catalogue = Catalogue.load();
    NetworkSettings settings =
        NetworkSettings.CAMSIM.withStrategies(List.of(new Strategy(schedule, communicationPolicy)));
    Scenario read = scenario.with(Scenario.ZOOMS, List.of()).with(Scenario.ORDER, StepOrder.CAMSIM);
    Detection detection = Detection.of(catalogue.detection("camsim-visibility"));
    RunPlan plan =
        new RunPlan(
            CamSimScenario.withQuirks(read, settings),
            detection,
            "zoom-out",
            Scenario.MAX_STEPS,
            0,
            1);
    return NetworkRun.of(plan, settings, catalogue);
  }
}
