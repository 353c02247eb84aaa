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
 * The cameras and objects of a running CamSim as a {@link World} of ours, and what they see there:
 * in CamSim, cameras look at objects one by one.
 *
 * <p>CamSim does not say who is to come: the world has room for some that are not online (not
 * present) yet, see {@link #expect}. Where more come, it takes another one: {@link #begin}.
 */
final class LiveWorld implements Cooperation {
  private static final int MIN_ROOM = 8; // for targets
  private static final int NEVER = Integer.MAX_VALUE; // a step

  private final CamSim camsim;
  private final Aiming aiming;
  private final Object core;
  private final Visibility visibility;
  private final double size;
  private final CameraViews kind;
  private final Roster<LiveCamera> cameras = new Roster<>();
  private final Roster<LiveTarget> targets = new Roster<>();
  private int cameraRoom;
  private int targetRoom;
  private World world; // null before the first step

  /** An object of CamSim's, and its features. */
  private record LiveTarget(Object handle, String name) {}

  /**
   * @param core CamSim's {@code SimCore}
   * @param visibility what cameras see of objects, CamSim's rules included
   * @param size of every object, metres
   */
  LiveWorld(CamSim camsim, Object core, Visibility visibility, double size, CameraViews kind) {
    this.camsim = camsim;
    this.core = core;
    this.visibility = visibility;
    this.size = size;
    this.kind = kind;
    this.aiming = new Aiming(camsim);
  }

  @Override
  public Visibility visibility(Detection detection, long seed) {
    return visibility;
  }

  /** Takes note of where everything is now; what was seen stays. */
  void refresh() {
    cameras.update(
        camsim.cameras(core), handle -> new LiveCamera(handle, camsim.range(handle), kind));
    targets.update(camsim.objects(core), handle -> new LiveTarget(handle, camsim.features(handle)));
    for (int camera = 0; camera < cameras.all().size(); camera++) {
      LiveCamera eye = cameras.get(camera);
      boolean changed = cameras.isThere(camera) ? eye.refresh(camsim) : eye.switchOff();
      if (changed && fits()) {
        showCamera(camera);
      }
    }
    if (fits()) {
      showTargets();
    }
  }

  private void showCamera(int camera) {
    LiveCamera eye = cameras.get(camera);
    world.setCamera(camera, eye.name(), eye.pose(), eye.views());
    if (world.cameras().online(camera) != eye.online()) {
      world.switchCamera(camera, eye.online());
    }
  }

  private void showTargets() {
    for (int number = 0; number < targets.all().size(); number++) {
      LiveTarget target = targets.get(number);
      boolean there = targets.isThere(number);
      double x = there ? camsim.objectX(target.handle) : 0;
      double y = there ? camsim.objectY(target.handle) : 0;
      world.setTarget(number, target.name, there, x, y);
    }
  }

  /** Expects this many cameras and targets, of which some are to come. */
  void expect(int allCameras, int allTargets) {
    cameraRoom = allCameras;
    targetRoom = allTargets;
  }

  /** Whether there is a world, and room in it for all that there are. */
  boolean fits() {
    return world != null
        && cameras.all().size() <= cameraRoom
        && targets.all().size() <= targetRoom;
  }

  /**
   * Makes another world. Where there are more than were expected, it has room for the cameras there
   * are, and for twice the targets, which come more often.
   */
  World begin(Objective objective) {
    if (cameras.all().size() > cameraRoom || targets.all().size() > targetRoom) {
      expect(cameras.all().size(), 2 * targets.all().size() + MIN_ROOM);
    }
    CameraSpec camera = new CameraSpec("", 0, 0, 0);
    TargetSpec target = new TargetSpec(0, 0, 0).withSize(size); // at speed 0: CamSim moves it
    List<ScenarioEvent> toCome = new ArrayList<>();
    toCome.addAll(Collections.nCopies(cameraRoom, new ScenarioEvent.AddCamera(NEVER, camera)));
    toCome.addAll(Collections.nCopies(targetRoom, new ScenarioEvent.AddTarget(NEVER, target)));
    world =
        new World(
            new Scenario("", field())
                .with(Scenario.OBJECTIVE, objective)
                .with(Scenario.EVENTS, toCome),
            Movements.register(new Registry<>("movement")),
            0);
    LiveCamera unknown = new LiveCamera(null, 0, kind);
    for (int i = 0; i < cameraRoom; i++) {
      boolean known = i < cameras.all().size();
      world.setCamera(i, "", Pose.of(0, 0, 0), unknown.views());
      world.cameras().turnTo(i, known ? cameras.get(i).view() : unknown.view());
    }
    IntStream.range(0, cameras.all().size()).forEach(this::showCamera);
    showTargets();
    return world;
  }

  /** One that holds all cameras: CamSim's own is not asked for. */
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

  /** Turns CamSim's cameras to the views that were chosen. */
  void turn() {
    for (int camera = 0; camera < cameras.all().size(); camera++) {
      if (cameras.get(camera).online()) {
        cameras.get(camera).turnTo(world.cameras().view(camera), camsim, aiming);
      }
    }
  }

  /** Gives all cameras back what they had before any policy. */
  void restore() {
    cameras.all().forEach(camera -> camera.restore(camsim, aiming));
  }

  /** Forgets what was seen: cameras are about to look. */
  void forget() {
    cameras.all().forEach(camera -> camera.seen().clear());
  }

  /** The names of the cameras that there have been; empty where one is not known. */
  List<String> cameraNames() {
    return cameras.all().stream().map(LiveCamera::name).toList();
  }

  /** The cameras that there have been, as a scenario describes them. */
  List<CameraSpec> cameraSpecs() {
    return cameras.all().stream().map(LiveCamera::spec).toList();
  }

  /**
   * One of CamSim's cameras looks at one of its objects.
   *
   * @return the confidence; 0 where it is not visible; NaN where CamSim's lists lack one of them
   */
  double look(Object camera, Object object, long step) {
    if (cameras.number(camera) < 0 || targets.number(object) < 0) {
      refresh();
    }
    int eye = cameras.number(camera);
    int target = targets.number(object);
    if (eye < 0 || target < 0) {
      return Double.NaN;
    }
    LiveCamera looking = cameras.get(eye);
    double x = camsim.objectX(object);
    double y = camsim.objectY(object);
    double luck = visibility.luck(step, eye, target);
    double confidence = sight(looking).confidence(looking.viewPose(), x, y, luck, 1);
    saw(camera, object, confidence > 0);
    return confidence;
  }

  private LevelSight sight(LiveCamera camera) {
    return visibility.at(camera.zoom(), size);
  }

  /** Records what came of a camera's look at an object in this step. */
  void saw(Object camera, Object object, boolean visible) {
    int eye = cameras.number(camera);
    int target = targets.number(object);
    if (eye >= 0 && target >= 0) {
      cameras.get(eye).seen().set(target, visible);
    }
  }

  @Override
  public void observe(Observation observation) {
    int[] detected = observation.detected();
    int[] coverage = observation.coverage();
    Arrays.fill(detected, 0);
    Arrays.fill(coverage, 0);
    for (int camera = 0; camera < Math.min(cameraRoom, cameras.all().size()); camera++) {
      BitSet seen = cameras.get(camera).seen();
      detected[camera] = cameras.get(camera).online() ? seen.cardinality() : 0;
      seen.stream().filter(target -> target < targetRoom).forEach(target -> coverage[target]++);
    }
  }

  /**
   * Whether what CamSim sees of an object comes from where the object says that it is, by CamSim's
   * own formula (behaviour 6.1). Where nothing is seen and nothing was to be, that is not known.
   *
   * @throws InputException when it does not
   */
  boolean agrees(Object camera, Object object, double confidence) {
    LiveCamera eye = cameras.get(cameras.number(camera));
    double x = camsim.objectX(object);
    double y = camsim.objectY(object);
    double expected = DetectionModel.clamp(sight(eye).value(eye.viewPose(), x, y));
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
