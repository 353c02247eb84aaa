package org.hificamsim.profiling.boxes;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.Seen;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.StepPhase;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Extent;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;
import org.hificamsim.profiling.check.Calibration;
import org.hificamsim.profiling.check.Calibration.Size;

/**
 * A recording by a calibrated camera as a scenario: its people stand where their boxes stand by the
 * calibration, before a pinhole camera at the height and tilt of the real one. It uses nothing else
 * of the boxes: neither their heights nor who hides whom.
 */
public final class SimulatedRecording {
  /** The width of the field around the people, in metres. */
  private static final double MARGIN = 10;

  /** The greatest distance at which a camera has to see, in metres. */
  private static final double REACH = 1000;

  /**
   * The size of the simulated picture as a multiple of the real one, at the same scale: whoever is
   * labelled is in the picture, even if roll and distortion move them across the border.
   */
  private static final double WIDENING = 1.2;

  /** A person in a frame. */
  private record Standing(int target, double x, double y, PersonBox box) {}

  private final Calibration camera;
  private final Size body;
  private final Map<String, Integer> targets = new LinkedHashMap<>();
  private final Map<Long, List<Standing>> frames = new LinkedHashMap<>();
  private final double[] bounds = {
    Double.MAX_VALUE, -Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE
  };
  private int withoutPlace;

  /**
   * Places the people of one measured recording.
   *
   * @param file the file of the labels, for error messages
   * @param body the assumed size of people, in metres
   */
  public SimulatedRecording(Path file, MeasuredBoxes measured, Calibration camera, Size body) {
    this.camera = camera;
    this.body = body;
    measured.boxes().forEach(this::addPerson);
    if (frames.isEmpty()) {
      throw InputException.of(
          "%s: nobody stands on the ground before the calibrated camera, expected somebody", file);
    }
  }

  private void addPerson(PersonBox person) {
    Box box = person.box();
    Vector3D foot = camera.ground(box.left() + box.width() / 2, box.bottom());
    double away = foot.subtract(camera.position()).getNorm();
    if (!(away < REACH)) {
      withoutPlace++;
      return;
    }
    int target = targets.computeIfAbsent(person.person(), id -> targets.size());
    frames
        .computeIfAbsent(person.frame(), frame -> new ArrayList<>())
        .add(new Standing(target, foot.getX(), foot.getY(), person));
    bounds[0] = Math.min(bounds[0], foot.getX() - MARGIN);
    bounds[1] = Math.max(bounds[1], foot.getX() + MARGIN);
    bounds[2] = Math.min(bounds[2], foot.getY() - MARGIN);
    bounds[3] = Math.max(bounds[3], foot.getY() + MARGIN);
  }

  /** Returns the number of boxes that stand nowhere on the ground before the camera. */
  public int withoutPlace() {
    return withoutPlace;
  }

  /** Returns what a detection expects of each person in each frame. */
  public ExpectedPeople expected(Detection detection) {
    World world = new World(scenario(), Movements.registry(), 0);
    Simulation simulation = new Simulation(world, detection, new OnlyView(), 0, List.of());
    List<PersonBox> people = new ArrayList<>();
    List<Double> chances = new ArrayList<>();
    for (List<Standing> frame : frames.values()) {
      arrange(world, frame);
      simulation.phases().runUntil(StepPhase.DECIDE);
      for (Standing person : frame) {
        people.add(person.box());
        chances.add(simulation.network().chance(0, 0, person.target()));
      }
      simulation.phases().finishStep();
    }
    return new ExpectedPeople(
        detection.name(), people, chances.stream().mapToDouble(Double::doubleValue).toArray());
  }

  private static void arrange(World world, List<Standing> frame) {
    for (int target = 0; target < world.targets().count(); target++) {
      world.setTarget(target, world.targets().name(target), false, 0, 0);
    }
    for (Standing person : frame) {
      world.setTarget(
          person.target(), world.targets().name(person.target()), true, person.x(), person.y());
    }
  }

  /** The scenario of the camera, with all people at its start. */
  private Scenario scenario() {
    Extent extent = new Extent(body.width(), body.height());
    List<TargetSpec> people =
        targets.values().stream()
            .map(
                target ->
                    new TargetSpec(target, bounds[0] + MARGIN, bounds[2] + MARGIN)
                        .withExtent(extent))
            .toList();
    return new Scenario("recording", new Field(bounds[0], bounds[1], bounds[2], bounds[3]))
        .with(Scenario.CAMERAS, List.of(simulatedCamera()))
        .with(Scenario.TARGETS, people)
        .with(Scenario.SEEN, Seen.FEET);
  }

  private CameraSpec simulatedCamera() {
    Vector3D axis = axis();
    Vector3D position = camera.position();
    Size picture =
        new Size(
            Math.rint(WIDENING * camera.picture().width()),
            Math.rint(WIDENING * camera.picture().height()));
    double focal = camera.focalLength();
    OpticsSpec optics =
        new OpticsSpec("lens")
            .with(OpticsSpec.PIXELS, (int) picture.width())
            .with(OpticsSpec.ANGLES_OF_VIEW, List.of(angle(picture.width(), focal)))
            .with(OpticsSpec.VERTICAL_ANGLES, List.of(angle(picture.height(), focal)))
            .with(OpticsSpec.REACH, REACH);
    return new CameraSpec("camera", position.getX(), position.getY(), REACH)
        .with(CameraSpec.HEADING, Math.toDegrees(Math.atan2(axis.getX(), axis.getY())))
        .with(CameraSpec.OPTICS, optics)
        .with(CameraSpec.Z, position.getZ())
        .with(
            CameraSpec.TILT,
            Math.toDegrees(-Math.atan2(axis.getZ(), Math.hypot(axis.getX(), axis.getY()))));
  }

  /**
   * The direction of the middle of the picture, which need not be that of the lens: a simulated
   * picture is centred.
   */
  private Vector3D axis() {
    Vector3D middle = camera.ground(camera.picture().width() / 2, camera.picture().height() / 2);
    return middle.isNaN() ? camera.along() : middle.subtract(camera.position()).normalize();
  }

  private static double angle(double pixels, double focal) {
    return Math.toDegrees(2 * Math.atan(pixels / 2 / focal));
  }

  /** Keeps the only view of the camera. */
  private static final class OnlyView implements ZoomPolicy {
    @Override
    public String name() {
      return "only-view";
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      Arrays.fill(views, 0);
    }
  }
}
