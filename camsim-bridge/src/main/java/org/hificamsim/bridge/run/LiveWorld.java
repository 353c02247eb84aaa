package org.hificamsim.bridge.run;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.bridge.camsim.Aiming;
import org.hificamsim.bridge.camsim.CamSim;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.engine.Cooperation;
import org.hificamsim.core.engine.Observation;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.visibility.LevelSight;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;

/**
 * Represents the cameras and objects of a running CamSim, and what the cameras see, as a {@link
 * World}.
 *
 * <p>CamSim does not announce future cameras and objects, so the world has a capacity for those not
 * yet online or present, see {@link #expect}. If it is exceeded, {@link #begin} creates a larger
 * world.
 */
final class LiveWorld implements Cooperation {
  private static final int MIN_TARGET_CAPACITY = 8;

  /** A step that is never reached. */
  private static final int NEVER = Integer.MAX_VALUE;

  private final CamSim camsim;
  private final Aiming aiming;
  private final Object core;
  private final Visibility visibility;
  private final double size;
  private final CameraViews cameraViews;
  private final Roster<LiveCamera> cameras = new Roster<>();
  private final Roster<LiveTarget> targets = new Roster<>();
  private int cameraCapacity;
  private int targetCapacity;

  /** The world; null before the first step. */
  private World world;

  /** An object of CamSim, with its features as its name. */
  private record LiveTarget(Object handle, String name) {}

  /**
   * @param core the {@code SimCore} of CamSim
   * @param visibility decides which objects cameras see, by CamSim's rules
   * @param size the size of every object, in metres
   */
  LiveWorld(
      CamSim camsim, Object core, Visibility visibility, double size, CameraViews cameraViews) {
    this.camsim = camsim;
    this.core = core;
    this.visibility = visibility;
    this.size = size;
    this.cameraViews = cameraViews;
    this.aiming = new Aiming(camsim);
  }

  @Override
  public Visibility visibility(Detection detection, long seed) {
    return visibility;
  }

  /** Reads cameras and objects from CamSim again, but not what cameras see. */
  void refresh() {
    cameras.update(
        camsim.cameras(core), handle -> new LiveCamera(handle, camsim.range(handle), cameraViews));
    targets.update(camsim.objects(core), handle -> new LiveTarget(handle, camsim.features(handle)));
    for (int camera = 0; camera < cameras.all().size(); camera++) {
      LiveCamera liveCamera = cameras.get(camera);
      boolean changed =
          cameras.isPresent(camera) ? liveCamera.refresh(camsim) : liveCamera.switchOff();
      if (changed && hasCapacity()) {
        updateCamera(camera);
      }
    }
    if (hasCapacity()) {
      updateTargets();
    }
  }

  private void updateCamera(int camera) {
    LiveCamera liveCamera = cameras.get(camera);
    world.setCamera(camera, liveCamera.name(), liveCamera.pose(), liveCamera.views());
    if (world.cameras().online(camera) != liveCamera.online()) {
      world.switchCamera(camera, liveCamera.online());
    }
  }

  private void updateTargets() {
    for (int number = 0; number < targets.all().size(); number++) {
      LiveTarget target = targets.get(number);
      boolean present = targets.isPresent(number);
      double x = present ? camsim.objectX(target.handle) : 0;
      double y = present ? camsim.objectY(target.handle) : 0;
      world.setTarget(number, target.name, present, x, y);
    }
  }

  /** Sets the expected numbers of cameras and targets, including future ones. */
  void expect(int allCameras, int allTargets) {
    cameraCapacity = allCameras;
    targetCapacity = allTargets;
  }

  /** Returns whether there is a world that has the capacity for all cameras and targets. */
  boolean hasCapacity() {
    return world != null
        && cameras.all().size() <= cameraCapacity
        && targets.all().size() <= targetCapacity;
  }

  /**
   * Creates a new world. If there are more cameras or targets than expected, it has the capacity
   * for the present cameras and twice the present targets, since more targets than cameras are
   * added.
   */
  World begin(Objective objective) {
    if (cameras.all().size() > cameraCapacity || targets.all().size() > targetCapacity) {
      expect(cameras.all().size(), 2 * targets.all().size() + MIN_TARGET_CAPACITY);
    }
    CameraSpec camera = new CameraSpec("", 0, 0, 0);
    // Speed 0, since CamSim moves the targets.
    TargetSpec target = new TargetSpec(0, 0, 0).withSize(size);
    List<ScenarioEvent> futureEvents = new ArrayList<>();
    futureEvents.addAll(
        Collections.nCopies(cameraCapacity, new ScenarioEvent.AddCamera(NEVER, camera)));
    futureEvents.addAll(
        Collections.nCopies(targetCapacity, new ScenarioEvent.AddTarget(NEVER, target)));
    world =
        new World(
            new Scenario("", field())
                .with(Scenario.OBJECTIVE, objective)
                .with(Scenario.EVENTS, futureEvents),
            Movements.register(new Registry<>("movement")),
            0);
    LiveCamera placeholder = new LiveCamera(null, 0, cameraViews);
    for (int i = 0; i < cameraCapacity; i++) {
      boolean known = i < cameras.all().size();
      world.setCamera(i, "", Pose.of(0, 0, 0), placeholder.views());
      world.cameras().turnTo(i, known ? cameras.get(i).view() : placeholder.view());
    }
    IntStream.range(0, cameras.all().size()).forEach(this::updateCamera);
    updateTargets();
    return world;
  }

  /** Returns a field that contains all cameras; CamSim's own field is not read. */
  private Field field() {
    DoubleSummaryStatistics x = new DoubleSummaryStatistics();
    DoubleSummaryStatistics y = new DoubleSummaryStatistics();
    for (LiveCamera camera : cameras.all()) {
      x.accept(camera.pose().x());
      y.accept(camera.pose().y());
    }
    return cameras.all().isEmpty()
        ? new Field(0, 0, 0, 0)
        : new Field(x.getMin(), x.getMax(), y.getMin(), y.getMax());
  }

  /** Turns CamSim's cameras to the chosen views. */
  void turnCameras() {
    for (int camera = 0; camera < cameras.all().size(); camera++) {
      if (cameras.get(camera).online()) {
        cameras.get(camera).turnTo(world.cameras().view(camera), camsim, aiming);
      }
    }
  }

  /** Restores the aims that all cameras had before any policy. */
  void restoreCameras() {
    cameras.all().forEach(camera -> camera.restore(camsim, aiming));
  }

  /** Forgets what cameras saw, before they look again. */
  void forgetSightings() {
    cameras.all().forEach(camera -> camera.seen().clear());
  }

  /** The names of all cameras so far; an unknown name is empty. */
  List<String> cameraNames() {
    return cameras.all().stream().map(LiveCamera::name).toList();
  }

  /** The specifications of all cameras so far. */
  List<CameraSpec> cameraSpecs() {
    return cameras.all().stream().map(LiveCamera::spec).toList();
  }

  /**
   * Lets a camera look at an object.
   *
   * @return the confidence; 0 if the object is not visible; NaN if CamSim's lists lack one of the
   *     two
   */
  double look(Object camera, Object object, long step) {
    if (cameras.number(camera) < 0 || targets.number(object) < 0) {
      refresh();
    }
    int number = cameras.number(camera);
    int target = targets.number(object);
    if (number < 0 || target < 0) {
      return Double.NaN;
    }
    LiveCamera looking = cameras.get(number);
    double x = camsim.objectX(object);
    double y = camsim.objectY(object);
    double luck = visibility.luck(step, number, target);
    double confidence = sight(looking).confidence(looking.viewPose(), x, y, luck, 1);
    recordLook(camera, object, confidence > 0);
    return confidence;
  }

  private LevelSight sight(LiveCamera camera) {
    return visibility.at(camera.zoom(), size);
  }

  /** Records whether a camera saw an object in this step. */
  void recordLook(Object camera, Object object, boolean visible) {
    int number = cameras.number(camera);
    int target = targets.number(object);
    if (number >= 0 && target >= 0) {
      cameras.get(number).seen().set(target, visible);
    }
  }

  @Override
  public void observe(Observation observation) {
    int[] detected = observation.detected();
    int[] coverage = observation.coverage();
    Arrays.fill(detected, 0);
    Arrays.fill(coverage, 0);
    for (int camera = 0; camera < Math.min(cameraCapacity, cameras.all().size()); camera++) {
      BitSet seen = cameras.get(camera).seen();
      detected[camera] = cameras.get(camera).online() ? seen.cardinality() : 0;
      seen.stream().filter(target -> target < targetCapacity).forEach(target -> coverage[target]++);
    }
  }

  /**
   * Checks by CamSim's formula (behaviour 6.1) that CamSim looks at an object where its track is.
   *
   * @return whether the check was possible: false if the object is invisible as expected
   * @throws InputException if CamSim looks elsewhere
   */
  boolean checkTrack(Object camera, Object object, double confidence) {
    LiveCamera liveCamera = cameras.get(cameras.number(camera));
    double x = camsim.objectX(object);
    double y = camsim.objectY(object);
    double expected = DetectionModel.clamp(sight(liveCamera).value(liveCamera.viewPose(), x, y));
    double seen = DetectionModel.clamp(confidence);
    if (Math.abs(seen - expected) > 1e-9) {
      throw InputException.of(
          "CamSim sees object %s with confidence %s, and its track gives %s: another"
              + " version of CamSim",
          camsim.features(object), seen, expected);
    }
    return seen > 0;
  }
}
