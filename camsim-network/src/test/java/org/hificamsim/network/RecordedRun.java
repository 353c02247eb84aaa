package org.hificamsim.network;

import java.util.List;
import java.util.Set;
import org.hificamsim.core.CamSimCommand;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.engine.WidestPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;
import org.hificamsim.network.NetworkSettings.GraphUse;
import org.hificamsim.network.agent.Named;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.network.bandit.BanditAlgorithm;

/** A recorded run of CamSim, repeated with our network. */
record RecordedRun(CamSimCommand command) {
  /** Receives the state after each step of a run. */
  interface Watcher {
    void stepped(World world, Network network);
  }

  NetworkSettings settings(Set<Quirk> quirks) {
    NetworkSettings camsim = NetworkSettings.CAMSIM;
    return new NetworkSettings(
        List.of(),
        command.option("-a").map(name -> Named.find(ScheduleKind.class, name).orElseThrow()),
        command
            .number("-c")
            .map(number -> CommunicationSetting.of(number, command.option("-u")).orElseThrow()),
        command.option("-b").map(name -> Named.find(BanditAlgorithm.class, name).orElseThrow()),
        command.number("-v").flatMap(GraphUse::find).orElse(GraphUse.AS_IN_FILE),
        command.number("-e").orElse(camsim.errorLevel()),
        command.number("-r").orElse(camsim.resetLevel()),
        camsim.banditParameters(),
        camsim.historicalParameters(),
        quirks);
  }

  /** Runs with all quirks of CamSim. */
  void run(Watcher watcher) {
    run(NetworkSettings.CAMSIM.quirks(), watcher);
  }

  /** Runs with some quirks of CamSim. */
  void run(Set<Quirk> quirks, Watcher watcher) {
    NetworkSettings settings = settings(quirks);
    Detection detection = Detection.of(new CamSimVisibilityDetection());
    Scenario scenario = CamSimScenario.withQuirks(command.read(), settings);
    NetworkRun run =
        new NetworkRun(
            scenario,
            detection,
            new WidestPolicy(),
            Movements.registry(),
            settings,
            command.seed());
    run.listen((view, coverage) -> watcher.stepped(run.world(), run.network()))
        .run(command.steps());
  }
}
