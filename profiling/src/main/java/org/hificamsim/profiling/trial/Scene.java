package org.hificamsim.profiling.trial;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.core.scenario.OpticsSpec;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.StepOrder;
import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;
import org.hificamsim.profiling.dataset.PhotoCamera;
import org.hificamsim.profiling.measure.Measurement;

/**
 * Photos of one object as a scenario: the object is a target in the middle, and each photo a camera
 * with its lens and at its distance, which looks at it.
 *
 * @param photos of one object, one or more
 * @param bearings where the cameras stand as seen from the target, degrees
 */
record Scene(List<Measurement> photos, List<Double> bearings) {
  private static final double ROOM = 1.1;
  private static final Registry<Movement> MOVEMENTS =
      Movements.register(new Registry<>("movement"));

  /** One photo. */
  static Scene of(Measurement photo) {
    return new Scene(List.of(photo), List.of(0.0));
  }

  /** Photos drawn from those of an object, around it in directions that are drawn too. */
  static Scene drawn(List<Measurement> ofObject, int cameras, SplittableRandom random) {
    List<Measurement> left = new ArrayList<>(ofObject);
    List<Measurement> photos = new ArrayList<>();
    List<Double> bearings = new ArrayList<>();
    for (int camera = 0; camera < cameras && !left.isEmpty(); camera++) {
      photos.add(left.remove(random.nextInt(left.size())));
      bearings.add(random.nextDouble(360));
    }
    return new Scene(photos, bearings);
  }

  /**
   * The scenario.
   *
   * @param farthest a distance that no photo of the data set exceeds, so that scenes share zooms
   */
  Scenario scenario(PhotoCamera sensor, double farthest) {
    double half = ROOM * farthest;
    List<CameraSpec> cameras = new ArrayList<>();
    for (int i = 0; i < photos.size(); i++) {
      cameras.add(camera("photo " + i, photos.get(i), bearings.get(i), sensor));
    }
    return new Scenario("photos", new Field(-half, half, -half, half))
        .with(Scenario.ORDER, StepOrder.COVERAGE)
        .with(Scenario.CAMERAS, cameras)
        .with(Scenario.TARGETS, List.of(new TargetSpec(1, 0, 0).withSize(photos.get(0).size())));
  }

  private static CameraSpec camera(
      String name, Measurement photo, double bearing, PhotoCamera sensor) {
    double radians = StrictMath.toRadians(bearing);
    double x = photo.distance() * StrictMath.sin(radians);
    double y = photo.distance() * StrictMath.cos(radians);
    double angle =
        StrictMath.toDegrees(2 * StrictMath.atan(sensor.sensorWidth() / (2 * photo.focalLength())));
    OpticsSpec lens =
        new OpticsSpec("lens of " + angle).with(OpticsSpec.ANGLES_OF_VIEW, List.of(angle));
    return new CameraSpec(name, x, y, 0)
        .with(CameraSpec.HEADING, bearing + 180)
        .with(CameraSpec.VIEWING_ANGLE, angle)
        .with(CameraSpec.OPTICS, lens);
  }

  /** How a scene's target is covered after one step of the simulation itself. */
  static StepCoverage coverage(Scenario scene, Detection detection) {
    World world = new World(scene, MOVEMENTS, 0);
    Simulation simulation = new Simulation(world, detection, new Still(), 0, List.of());
    simulation.run(1);
    return simulation.coverage();
  }

  /** Cameras stay as they are. */
  private static final class Still implements ZoomPolicy {
    @Override
    public String name() {
      return "still";
    }

    @Override
    public void decide(NetworkView network, int[] views) {}
  }
}
