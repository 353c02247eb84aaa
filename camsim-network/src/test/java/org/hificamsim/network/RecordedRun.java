package org.hificamsim.network;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.hificamsim.core.Reference;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.engine.WidestPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;
import org.hificamsim.network.agent.Named;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.network.bandit.BanditAlgorithm;

/**
 * A run of CamSim's that was recorded, to be run again here.
 *
 * @param scenario file name below the reference scenarios
 * @param options CamSim's command line, without the file
 */
record RecordedRun(String scenario, List<String> options) {
  /** Watches a run. */
  interface Watcher {
    void stepped(World world, Network network);
  }

  static RecordedRun of(String scenario, String options) {
    return new RecordedRun(scenario, Arrays.asList(options.strip().split("\\s+")));
  }

  int steps() {
    return Integer.parseInt(option("-t").orElseThrow());
  }

  long seed() {
    return Long.parseLong(option("-s").orElse("0"));
  }

  private Optional<String> option(String name) {
    int place = options.indexOf(name);
    return place < 0 ? Optional.empty() : Optional.of(options.get(place + 1));
  }

  NetworkSettings settings(Set<Quirk> quirks) {
    NetworkSettings camsim = NetworkSettings.CAMSIM;
    return new NetworkSettings(
        option("-a").map(name -> Named.find(ScheduleKind.class, name).orElseThrow()),
        option("-c").map(c -> Comm.of(Integer.parseInt(c), option("-u")).orElseThrow()),
        option("-b").map(name -> Named.find(BanditAlgorithm.class, name).orElseThrow()),
        option("-v").flatMap(v -> GraphUse.find(Integer.parseInt(v))).orElse(GraphUse.AS_IN_FILE),
        option("-e").map(Integer::parseInt).orElse(camsim.errorLevel()),
        option("-r").map(Integer::parseInt).orElse(camsim.resetLevel()),
        camsim.banditParameters(),
        camsim.historicalParameters(),
        quirks);
  }

  /** Runs it with all of CamSim's quirks. */
  void run(Watcher watcher) {
    run(NetworkSettings.CAMSIM.quirks(), watcher);
  }

  /** Runs it with some of CamSim's quirks. */
  void run(Set<Quirk> quirks, Watcher watcher) {
    NetworkSettings settings = settings(quirks);
    Scenario read =
        ScenarioReader.read(
            Reference.file("camsim/scenarios/" + scenario),
            anyMovement -> true,
            new ArrayList<>()::add);
    if (option("-m").isPresent()) {
      read = read.withMovement(option("-m").get());
    }
    World world = new World(CamSimScenario.as(read, settings), Movements.registry(), seed());
    Detection detection = Detection.of(new CamSimVisibilityDetection());
    Network network = new Network(world, detection, settings, seed());
    StepListener listener = (view, coverage) -> watcher.stepped(world, network);
    new Simulation(world, detection, new WidestPolicy(), network, seed(), List.of(listener))
        .run(steps());
  }
}
