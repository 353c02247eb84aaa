package org.example;

import java.nio.file.Path;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.RunCoverage;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.World;

/** Simulates a scenario file, with everything found by name. */
final class TenLines {
  private TenLines() {}

  public static void main(String[] args) {
    Catalogue catalogue = Catalogue.load();
    Scenario scenario =
        ScenarioReader.read(Path.of(args[0]), catalogue.movements()::knows, System.err::println);
    World world = new World(scenario, catalogue.movements(), 42);
    Detection detection = Detection.of(catalogue.detection("hifi:orb-lin"));
    ZoomPolicy policy = catalogue.policies().create("sarsa:gamma=0.9");
    RunCoverage coverage = new RunCoverage();
    new Simulation(world, detection, policy, 42, List.of(coverage)).run(1000);
    System.out.printf("performance %d%n", coverage.performance());
    System.out.printf("mean k_min %.3f%n", coverage.meanKMin());
    System.out.printf("uncovered %.1f%%%n", 100 * coverage.proportion0());
  }
}
