package org.hificamsim.bench.plain;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.TargetSpec;

/**
 * The step of the coverage study as a loop over objects: cameras zoom, observe and learn, and
 * targets move. It takes scenarios of all-round cameras, a common zoom list and straight movement,
 * without events.
 */
public final class PlainSimulation {
  private final Field field;
  private final List<Camera> cameras = new ArrayList<>();
  private final List<Target> targets = new ArrayList<>();
  private final DetectionFunction detection;
  private final Random turns;
  private int detections;

  /**
   * @param detection {@code hifi:orb-lin} or {@code camsim-range@0.3}
   * @param policy {@code zoom-out}, {@code epsilon-greedy} or {@code sarsa}
   * @param epsilon the probability that a learning camera explores, in [0, 1]
   */
  public PlainSimulation(
      Scenario scenario, String detection, String policy, double epsilon, long seed) {
    this.detection = DetectionFunction.named(detection);
    field = scenario.field();
    turns = new Random(seed);
    Random random = new Random(seed);
    List<Double> radii = scenario.zooms();
    for (CameraSpec camera : scenario.cameras()) {
      LevelPolicy policyOfCamera = policy(policy, radii.size(), epsilon, random);
      cameras.add(new Camera(camera.x(), camera.y(), radii, policyOfCamera));
    }
    for (TargetSpec target : scenario.targets()) {
      double heading = Math.toRadians(target.heading());
      targets.add(new Target(target.x(), target.y(), heading, target.speed(), target.size()));
    }
  }

  /** Makes one step, and returns its k_min. */
  public int step() {
    for (Camera camera : cameras) {
      camera.zoom();
    }
    for (Target target : targets) {
      target.uncover();
    }
    for (Camera camera : cameras) {
      camera.observe(targets, detection);
    }
    int kMin = cameras.size();
    detections = 0;
    for (Target target : targets) {
      detections += target.coverage();
      kMin = Math.min(kMin, target.coverage());
    }
    for (Target target : targets) {
      target.move(field, turns);
    }
    return kMin;
  }

  /** The number of detections in the last step: one for each camera and target. */
  public int detections() {
    return detections;
  }

  /** Returns how many targets no, one, and two or more cameras covered in the last step. */
  int[] covered() {
    int[] covered = new int[3];
    for (Target target : targets) {
      covered[Math.min(target.coverage(), 2)]++;
    }
    return covered;
  }

  private static LevelPolicy policy(String name, int levels, double epsilon, Random random) {
    return switch (name) {
      case "zoom-out" -> (level, detected) -> levels - 1;
      case "epsilon-greedy" -> new EpsilonGreedy(levels, epsilon, random);
      case "sarsa" -> new Sarsa(levels, epsilon, random);
      default -> throw new IllegalArgumentException("no plain policy '" + name + "'");
    };
  }
}
