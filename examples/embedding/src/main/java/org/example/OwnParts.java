package org.example;

import java.nio.file.Path;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.RandomStreams;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/** Plugs parts of one's own straight into the engine, without a jar or a service file. */
final class OwnParts {
  private OwnParts() {}

  /** A detection model that is certain up to four metres at any zoom level. */
  record FourMetres() implements DetectionModel {
    @Override
    public String name() {
      return "four-metres";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return distance <= 4 ? 1 : 0;
    }
  }

  /** A policy that puts every camera in the middle one of its views. */
  record Middle() implements ZoomPolicy {
    @Override
    public String name() {
      return "middle";
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      for (int camera = 0; camera < views.length; camera++) {
        views[camera] = network.views(camera) / 2;
      }
    }
  }

  /** A movement by half a metre to the east and back. */
  static final class Swaying implements Movement {
    private double dx = -0.5;

    @Override
    public String name() {
      return "Swaying";
    }

    @Override
    public void move(int target, Targets targets, RandomStreams random) {
      dx = -dx;
      targets.advance(target, dx, 0, random.turn());
    }
  }

  public static void main(String[] args) {
    Registry<Movement> movements = Catalogue.load().movements();
    movements.register("Swaying", "back and forth", Swaying::new);
    Scenario scenario =
        ScenarioReader.read(Path.of(args[0]), movements::knows, System.err::println);
    World world = new World(scenario.withMovement("Swaying"), movements, 0);
    StepListener printer =
        (network, coverage) ->
            System.out.printf(
                "step %d: camera %s sees %d of %d targets%n",
                network.step(), network.cameraName(0), network.detected(0), coverage.targets());
    Simulation simulation =
        new Simulation(world, Detection.of(new FourMetres()), new Middle(), 0, List.of(printer));
    for (int i = 0; i < 3; i++) {
      simulation.step();
      int least = simulation.coverage().kMin();
      int seen = simulation.network().coverage(0);
      System.out.println("k_min " + least + ", target 0 is seen by " + seen);
    }
  }
}
