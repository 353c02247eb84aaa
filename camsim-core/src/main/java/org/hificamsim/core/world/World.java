package org.hificamsim.core.world;

import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.visibility.Pose;

/**
 * The state of a running scenario: cameras and targets in flat arrays, and the coming events.
 *
 * <p>Cameras and targets are numbered in the order of the file, those of the start first, then
 * those that events add, in the order in which they appear.
 */
public final class World {
  private final Participants participants;
  private final ScenarioObstacles obstacles;
  private final Cameras cameras;
  private final Targets targets;
  private final SightLines sightLines;
  private final Registry<Movement> registry;
  private final Movement[] movements;
  private final RandomStreams random;
  private final Shifts shifts;
  private WorldObserver observer = WorldObserver.NONE;
  private int nextEvent;
  private int nextCamera;
  private int nextTarget;

  /**
   * Creates the world at its start, before the events of step 0.
   *
   * @throws InputException if a target names a movement that is not registered
   */
  public World(Scenario scenario, Registry<Movement> registry, long seed) {
    this(Participants.of(scenario), ScenarioObstacles.of(scenario), registry, seed, null);
  }

  private World(
      Participants participants,
      ScenarioObstacles obstacles,
      Registry<Movement> registry,
      long seed,
      SightLines shared) {
    this.participants = participants;
    this.obstacles = obstacles;
    this.registry = registry;
    this.random = new RandomStreams(seed);
    Scenario scenario = participants.scenario();
    cameras = new Cameras(participants.cameras().size());
    shifts = new Shifts(cameras);
    int count = participants.targets().size();
    targets = new Targets(scenario.field(), obstacles.all(), scenario.order(), count);
    movements = new Movement[count];
    start();
    sightLines = new SightLines(obstacles, scenario, cameras, targets, shared);
  }

  /**
   * Creates another world of the same scenario at its start. The two share immutable data only and
   * may run in different threads.
   */
  public World another(long seed) {
    return new World(participants, obstacles, registry, seed, sightLines);
  }

  /** Defines all cameras and targets, and adds those of the start. */
  private void start() {
    defineAll();
    scenario().cameras().forEach(camera -> addCamera());
    scenario().targets().forEach(target -> addTarget());
  }

  /**
   * Restarts the world with another seed. It equals a new world, but keeps the visible regions of
   * cameras that have not moved. Each restart needs a new {@link
   * org.hificamsim.core.engine.Simulation}.
   */
  public void restart(long seed) {
    random.restart(seed);
    nextEvent = 0;
    nextCamera = 0;
    nextTarget = 0;
    start();
    sightLines.refresh();
  }

  /** The different zoom levels of the cameras at the start, in the order of the file. */
  public static List<ZoomLevel> zoomLevels(Scenario scenario) {
    Views views = new Views(scenario);
    return scenario.cameras().stream()
        .flatMap(camera -> views.of(camera).zooms().stream())
        .distinct()
        .toList();
  }

  /** The zoom levels of one camera of a scenario at the start, from the narrowest. */
  public static List<ZoomLevel> zoomLevels(Scenario scenario, CameraSpec camera) {
    return new Views(scenario).of(camera).zooms();
  }

  /** The scenario that this world was made from. */
  public Scenario scenario() {
    return participants.scenario();
  }

  /** The cameras, live. */
  public Cameras cameras() {
    return cameras;
  }

  /** The targets, live. */
  public Targets targets() {
    return targets;
  }

  /** The obstacles between cameras and targets, as they are now. */
  public SightLines sightLines() {
    return sightLines;
  }

  /**
   * The scenario's description of a camera, even of one that is added later. Events that change the
   * camera do not change it.
   */
  public CameraSpec cameraSpec(int camera) {
    return participants.cameras().get(camera);
  }

  /** The scenario's description of a target, even of one that appears later. */
  public TargetSpec targetSpec(int target) {
    return participants.targets().get(target);
  }

  /** Sets the observer of events, in place of any other. */
  public void observe(WorldObserver newObserver) {
    observer = newObserver;
  }

  /** Switches a camera on or off, independently of events. */
  public void switchCamera(int camera, boolean on) {
    cameras.switchTo(camera, on);
  }

  /** Switches a camera off for ever, as an event does. */
  public void switchOffForEver(int camera) {
    switchOff(camera, -1);
  }

  /** Whether the duty cycle of a camera lets it sleep now. */
  public boolean sleeps(int camera) {
    return shifts.sleeps(camera);
  }

  /** Whether a camera is not there or was switched off; not if it sleeps. */
  public boolean isOff(int camera) {
    return !cameras.online(camera) && !shifts.sleeps(camera);
  }

  /** Moves a camera to a position in metres, independently of events. */
  public void moveCamera(int camera, double x, double y) {
    cameras.place(camera, Pose.of(x, y, cameras.heading(camera)));
    sightLines.refresh();
  }

  /** Turns a camera, independently of events; radians, 0 is +y and pi/2 is +x. */
  public void turnCamera(int camera, double heading) {
    cameras.place(camera, Pose.of(cameras.x(camera), cameras.y(camera), heading));
  }

  /** Sets a camera's name, pose and views, independently of events. */
  public void setCamera(int camera, String name, Pose pose, ViewSet views) {
    cameras.place(camera, name, participants.views().mount(pose, views));
    sightLines.refresh();
  }

  /** Sets a target's name, presence and position in metres, independently of events. */
  public void setTarget(int target, String name, boolean present, double x, double y) {
    targets.rename(target, name);
    if (present) {
      targets.appear(target, x, y, 0, 0);
    } else {
      targets.disappear(target);
    }
  }

  /**
   * Changes the range of a camera; a camera with a zoom list keeps its levels.
   *
   * @param range the range, in metres
   */
  public void changeRange(int camera, double range) {
    refit(camera, range, cameras.zoom(camera, 0).viewingAngle());
  }

  /** Fires the events of this step. */
  public void fireEvents(long step) {
    List<ScenarioEvent> events = participants.events();
    while (nextEvent < events.size() && events.get(nextEvent).step() <= step) {
      fire(nextEvent++);
    }
    shifts.begin(step);
    sightLines.refresh();
  }

  /** Moves all targets that are present by one step, in the order of their numbers. */
  public void moveTargets() {
    for (int target = 0; target < movements.length; target++) {
      if (targets.present(target)) {
        movements[target].move(target, targets, random);
      }
    }
  }

  private void fire(int number) {
    ScenarioEvent event = participants.events().get(number);
    if (event instanceof ScenarioEvent.AddCamera) {
      observer.cameraAdded(addCamera());
    } else if (event instanceof ScenarioEvent.ChangeCamera change) {
      changeCamera(change);
    } else if (event instanceof ScenarioEvent.FailCamera fail) {
      failCamera(fail);
    } else if (event instanceof ScenarioEvent.AddTarget) {
      observer.targetAppeared(addTarget());
    } else if (participants.removed().get(number) != Participants.NONE) {
      removeTarget(participants.removed().get(number));
    }
  }

  private int addCamera() {
    cameras.place(nextCamera, participants.mounts().get(nextCamera));
    cameras.switchTo(nextCamera, true);
    return nextCamera++;
  }

  private void changeCamera(ScenarioEvent.ChangeCamera change) {
    int camera = onlineCamera(change.camera());
    if (camera == Participants.NONE) {
      return;
    }
    cameras.place(
        camera,
        Pose.of(
            changed(change.x(), cameras.x(camera)),
            changed(change.y(), cameras.y(camera)),
            change.heading() == -1 ? cameras.heading(camera) : Math.toRadians(change.heading())));
    double angle =
        change.viewingAngle() == -1
            ? cameras.zoom(camera, 0).viewingAngle()
            : Math.toRadians(change.viewingAngle());
    double range = changed(change.range(), cameras.zoom(camera, 0).radius());
    refit(camera, range, angle);
    if (change.range() != -1) {
      observer.rangeChanged(camera);
    }
  }

  /** Gives a camera other views; one with a lens keeps its own. */
  private void refit(int camera, double range, double viewingAngle) {
    ViewSet set = participants.views().of(range, viewingAngle, cameraSpec(camera));
    cameras.place(camera, participants.views().mount(cameras.pose(camera), set));
  }

  private static double changed(double given, double before) {
    return given == -1 ? before : given;
  }

  private void failCamera(ScenarioEvent.FailCamera fail) {
    int camera = onlineCamera(fail.camera());
    if (camera != Participants.NONE && fail.duration() != 0) {
      switchOff(camera, fail.duration());
    }
  }

  private void switchOff(int camera, int duration) {
    shifts.end(camera);
    cameras.switchTo(camera, false);
    observer.cameraFailed(camera, duration);
  }

  private int onlineCamera(String name) {
    int camera = participants.cameraNumbers().getOrDefault(name, Participants.NONE);
    return camera != Participants.NONE && !isOff(camera) ? camera : Participants.NONE;
  }

  private int addTarget() {
    TargetSpec spec = targetSpec(nextTarget);
    double heading = scenario().headings().radians(spec.heading());
    targets.appear(nextTarget, spec.x(), spec.y(), heading, spec.speed());
    movements[nextTarget].start(nextTarget, targets, spec);
    return nextTarget++;
  }

  private void removeTarget(int target) {
    targets.disappear(target);
    observer.targetVanished(target);
  }

  private void defineAll() {
    for (int camera = 0; camera < cameras.count(); camera++) {
      cameras.define(camera, cameraSpec(camera).name(), participants.mounts().get(camera));
      shifts.define(camera, cameraSpec(camera));
    }
    cameras.startMotion(scenario().stepTime());
    for (int target = 0; target < movements.length; target++) {
      TargetSpec spec = targetSpec(target);
      targets.define(target, spec);
      movements[target] = registry.create(movementName(spec));
    }
  }

  private String movementName(TargetSpec spec) {
    String name = spec.movement();
    return scenario().inCoverageDialect() && name.equals("Waypoints") ? "Scripted" : name;
  }
}
