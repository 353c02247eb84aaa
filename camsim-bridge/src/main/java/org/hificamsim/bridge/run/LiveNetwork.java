package org.hificamsim.bridge.run;

import java.util.List;
import org.hificamsim.bridge.camsim.Aiming;
import org.hificamsim.bridge.camsim.CamSim;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.visibility.LevelSight;
import org.hificamsim.core.visibility.Visibility;

/**
 * The cameras and objects of a running CamSim, as policies and listeners know a network.
 *
 * <p>CamSim does not say who is to come: the counts hold room for some that are not online (not
 * present) yet, see {@link #expect}.
 */
final class LiveNetwork implements OracleView {
  private static final int MIN_ROOM = 8;

  private final CamSim camsim;
  private final Aiming aiming;
  private final Object core;
  private final Visibility visibility;
  private final double size;
  private final CameraViews kind;
  private final Objective objective;
  private final Roster<LiveCamera> cameras;
  private final Roster<LiveTarget> targets = new Roster<>(LiveTarget.TO_COME);
  private int revision;
  private long step;
  private long lastLook = -1;

  /**
   * @param core CamSim's {@code SimCore}
   * @param size of every object, metres
   */
  LiveNetwork(
      CamSim camsim,
      Object core,
      Visibility visibility,
      double size,
      CameraViews kind,
      Objective objective) {
    this.objective = objective;
    this.camsim = camsim;
    this.core = core;
    this.visibility = visibility;
    this.size = size;
    this.kind = kind;
    this.aiming = new Aiming(camsim);
    this.cameras = new Roster<>(LiveCamera.toCome(kind));
  }

  /** Takes note of where everything is in this step; what was seen stays. */
  void refresh(long newStep) {
    step = newStep;
    cameras.update(camsim.cameras(core), handle -> LiveCamera.of(handle, camsim, kind));
    for (int camera = 0; camera < cameras.all().size(); camera++) {
      LiveCamera eye = cameras.get(camera);
      boolean changed = cameras.isThere(camera) ? eye.refresh(camsim) : eye.switchOff();
      revision += changed ? 1 : 0;
    }
    targets.update(camsim.objects(core), handle -> new LiveTarget(handle, camsim.features(handle)));
    for (int target = 0; target < targets.all().size(); target++) {
      targets.get(target).refresh(camsim, targets.isThere(target));
    }
  }

  @Override
  public Objective objective() {
    return objective;
  }

  /** Forgets what was seen: cameras are about to look. */
  void forget() {
    lastLook = step;
    for (LiveCamera camera : cameras.all()) {
      camera.seen().clear();
    }
    targets.all().forEach(target -> target.coverage = 0);
  }

  /** Counts this many cameras and targets, of which some are to come. */
  void expect(int allCameras, int allTargets) {
    cameras.reserve(allCameras);
    targets.reserve(allTargets);
  }

  /** Whether there are more cameras or targets than were expected. */
  boolean outgrown() {
    return cameras.outgrown() || targets.outgrown();
  }

  /** Counts the cameras there are, and twice the targets, which come more often. */
  void makeRoom() {
    expect(cameras.all().size(), 2 * targets.all().size() + MIN_ROOM);
  }

  /** Turns a camera to a view, and CamSim's with it. */
  void turnTo(int camera, int view) {
    cameras.get(camera).turnTo(view, camsim, aiming);
  }

  /** Gives all cameras back what they had before any policy. */
  void restore() {
    cameras.all().forEach(camera -> camera.restore(camsim, aiming));
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
  double look(Object camera, Object object) {
    if (cameras.number(camera) < 0 || targets.number(object) < 0) {
      refresh(step);
    }
    int eye = cameras.number(camera);
    int target = targets.number(object);
    if (eye < 0 || target < 0) {
      return Double.NaN;
    }
    targets.get(target).refresh(camsim, true);
    LiveCamera looking = cameras.get(eye);
    double confidence = confidence(eye, looking.view(), target);
    saw(camera, object, confidence > 0);
    return confidence;
  }

  private double confidence(int camera, int view, int target) {
    LiveCamera eye = cameras.get(camera);
    double luck = visibility.luck(step, camera, target);
    return sight(camera, view)
        .confidence(eye.pose(view), targetX(target), targetY(target), luck, 1);
  }

  private LevelSight sight(int camera, int view) {
    return visibility.at(zoom(camera, view), size);
  }

  /** Records what came of a camera's look at an object in this step. */
  void saw(Object camera, Object object, boolean visible) {
    int eye = cameras.number(camera);
    int target = targets.number(object);
    if (eye >= 0 && target >= 0 && cameras.get(eye).seen().get(target) != visible) {
      cameras.get(eye).seen().set(target, visible);
      targets.get(target).coverage += visible ? 1 : -1;
    }
  }

  /**
   * Whether what CamSim sees of an object comes from where the object says that it is, by CamSim's
   * own formula (behaviour 6.1). Where nothing is seen and nothing was to be, that is not known.
   *
   * @throws InputException when it does not
   */
  boolean agrees(Object camera, Object object, double confidence) {
    int target = targets.number(object);
    double expected = confidence(cameras.number(camera), target);
    double seen = DetectionModel.clamp(confidence);
    if (Math.abs(seen - expected) > 1e-9) {
      throw InputException.of(
          "CamSim sees object %s with confidence %s, and its track gives %s: another"
              + " version of CamSim",
          targetName(target), seen, expected);
    }
    return seen > 0;
  }

  @Override
  public long step() {
    return step;
  }

  @Override
  public int revision() {
    return revision;
  }

  @Override
  public int cameras() {
    return cameras.count();
  }

  @Override
  public String cameraName(int camera) {
    return cameras.get(camera).name();
  }

  @Override
  public boolean online(int camera) {
    return cameras.get(camera).online();
  }

  @Override
  public double cameraX(int camera) {
    return cameras.get(camera).pose().x();
  }

  @Override
  public double cameraY(int camera) {
    return cameras.get(camera).pose().y();
  }

  @Override
  public double cameraHeading(int camera) {
    return cameras.get(camera).pose().heading();
  }

  @Override
  public int views(int camera) {
    return cameras.get(camera).views().count();
  }

  @Override
  public int zooms(int camera) {
    return cameras.get(camera).views().zooms().size();
  }

  @Override
  public int view(int camera) {
    return cameras.get(camera).view();
  }

  @Override
  public boolean reaches(int camera, int view) {
    return cameras.get(camera).views().isNextTo(view(camera), view);
  }

  @Override
  public double reach(int camera, int view) {
    return sight(camera, view).reach();
  }

  @Override
  public ZoomLevel zoom(int camera, int view) {
    return cameras.get(camera).views().zoom(view);
  }

  @Override
  public double pan(int camera, int view) {
    return cameras.get(camera).views().pan(view);
  }

  @Override
  public int detected(int camera) {
    LiveCamera eye = cameras.get(camera);
    return eye.online() ? eye.seen().cardinality() + phantoms(camera) : 0;
  }

  private int phantoms(int camera) {
    return lastLook < 0 ? 0 : visibility.phantoms(lastLook, camera);
  }

  @Override
  public int targets() {
    return targets.count();
  }

  @Override
  public String targetName(int target) {
    return targets.get(target).name;
  }

  @Override
  public boolean present(int target) {
    return targets.get(target).present;
  }

  @Override
  public double targetX(int target) {
    return targets.get(target).x;
  }

  @Override
  public double targetY(int target) {
    return targets.get(target).y;
  }

  @Override
  public int coverage(int target) {
    return targets.get(target).coverage;
  }

  @Override
  public double confidence(int camera, int target) {
    LiveCamera eye = cameras.get(camera);
    if (!present(target)) {
      return 0;
    }
    return DetectionModel.clamp(
        sight(camera, eye.view()).value(eye.pose(eye.view()), targetX(target), targetY(target)));
  }

  @Override
  public boolean detects(int camera, int view, int target) {
    return present(target) && confidence(camera, view, target) > 0;
  }

  @Override
  public boolean certain() {
    return visibility.detection().certain();
  }

  @Override
  public double chance(int camera, int view, int target) {
    return present(target)
        ? sight(camera, view)
            .chance(cameras.get(camera).pose(view), targetX(target), targetY(target), 1)
        : 0;
  }

  @Override
  public boolean dominates(int camera, int view, int other) {
    boolean whichWay = visibility.detection().model().dependsOnBearing();
    boolean sameWay =
        pan(camera, view) == pan(camera, other) || (zoom(camera, view).allRound() && !whichWay);
    return sameWay && sight(camera, view).includes(sight(camera, other));
  }
}
