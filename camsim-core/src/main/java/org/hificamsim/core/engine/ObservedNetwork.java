package org.hificamsim.core.engine;

import org.hificamsim.core.channel.Channel;
import org.hificamsim.core.channel.RadioLog;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.visibility.Body;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/** A simulated world as its cameras know it: their own state, and their detections. */
class ObservedNetwork implements NetworkView {
  final Cameras cameras;
  final Targets targets;
  final Sight sight;
  private final Observation observation;

  /** The processing budget; null if cameras process all that they see. */
  private final BudgetedSight budgeted;

  private final Objective objective;
  private final Field field;
  private Channel channel = Channel.PERFECT;
  private RadioLog radio = RadioLog.NONE;

  ObservedNetwork(World world, Sight sight, Observation observation) {
    this.cameras = world.cameras();
    this.targets = world.targets();
    this.sight = sight;
    this.observation = observation;
    this.budgeted = observation.budgeted();
    this.objective = world.scenario().objective();
    this.field = world.scenario().field();
  }

  /** Sends all messages over a channel in place of the perfect one. */
  void connect(Channel newChannel) {
    channel = newChannel;
  }

  /** Counts the bits that cameras send and receive. */
  void count(RadioLog newRadio) {
    radio = newRadio;
  }

  @Override
  public RadioLog radio() {
    return radio;
  }

  @Override
  public Objective objective() {
    return objective;
  }

  @Override
  public Channel channel() {
    return channel;
  }

  @Override
  public int revision() {
    return cameras.revision();
  }

  @Override
  public int cameras() {
    return cameras.count();
  }

  @Override
  public String cameraName(int camera) {
    return cameras.name(camera);
  }

  @Override
  public boolean online(int camera) {
    return cameras.online(camera);
  }

  @Override
  public double cameraX(int camera) {
    return cameras.x(camera);
  }

  @Override
  public double cameraY(int camera) {
    return cameras.y(camera);
  }

  @Override
  public double cameraHeading(int camera) {
    return cameras.heading(camera);
  }

  @Override
  public int views(int camera) {
    return cameras.views(camera);
  }

  @Override
  public int view(int camera) {
    return cameras.view(camera);
  }

  @Override
  public ZoomLevel zoom(int camera, int view) {
    return cameras.zoom(camera, view);
  }

  @Override
  public int zooms(int camera) {
    return cameras.zooms(camera);
  }

  @Override
  public double pan(int camera, int view) {
    return cameras.pan(camera, view);
  }

  @Override
  public int seeing(int camera) {
    return cameras.seeing(camera);
  }

  @Override
  public boolean moving(int camera) {
    return cameras.moving(camera);
  }

  @Override
  public boolean reaches(int camera, int view) {
    return cameras.reaches(camera, view);
  }

  @Override
  public int stepsTo(int camera, int view) {
    return cameras.stepsTo(camera, view);
  }

  @Override
  public int stepsBetween(int camera, int from, int view) {
    return cameras.stepsBetween(camera, from, view);
  }

  @Override
  public boolean movesBlindly(int camera) {
    return cameras.movesBlindly(camera);
  }

  @Override
  public double turnInStep(int camera) {
    return cameras.turnInStep(camera);
  }

  @Override
  public double zoomInStep(int camera) {
    return cameras.zoomInStep(camera);
  }

  @Override
  public int detected(int camera) {
    return observation.detected()[camera];
  }

  @Override
  public int targets() {
    return targets.count();
  }

  @Override
  public String targetName(int target) {
    return targets.name(target);
  }

  @Override
  public boolean present(int target) {
    return targets.present(target);
  }

  @Override
  public int coverage(int target) {
    return observation.coverage()[target];
  }

  @Override
  public double targetSize(int target) {
    return targets.seenSize(target);
  }

  @Override
  public long step() {
    return sight.step();
  }

  @Override
  public Field field() {
    return field;
  }

  @Override
  public Obstacles obstacles() {
    return sight.map();
  }

  @Override
  public double hidingWidth() {
    return sight.hidingWidth();
  }

  @Override
  public Body body(double size) {
    return sight.body(size);
  }

  @Override
  public double reach(int camera, int view) {
    return sight.reach(camera, view);
  }

  @Override
  public boolean chancesAt(
      int camera, double x, double y, double size, double transmittance, double[] chances) {
    return sight.chancesAt(camera, x, y, size, transmittance, chances);
  }

  @Override
  public double confidence(int camera, int target) {
    return budgeted == null
        ? sight.confidence(camera, target)
        : budgeted.confidence(camera, target);
  }

  @Override
  public double seenConfidence(int camera, int target, double distance) {
    return budgeted == null
        ? sight.seenConfidence(camera, target, distance)
        : budgeted.seenConfidence(camera, target, distance);
  }

  @Override
  public boolean sees(int camera, int target) {
    return budgeted == null ? sight.sees(camera, target) : budgeted.sees(camera, target);
  }

  @Override
  public double distance(int camera, int target) {
    return sees(camera, target)
        ? Math.hypot(
            seenX(camera, target) - cameras.x(camera), seenY(camera, target) - cameras.y(camera))
        : Double.NaN;
  }

  @Override
  public double bearing(int camera, int target) {
    if (!sees(camera, target)) {
      return Double.NaN;
    }
    double axis = cameras.heading(camera) + cameras.pan(camera, cameras.seeing(camera));
    double direction =
        Math.atan2(
            seenX(camera, target) - cameras.x(camera), seenY(camera, target) - cameras.y(camera));
    return Math.IEEEremainder(direction - axis, 2 * Math.PI);
  }

  @Override
  public void findSeen(SeenPairs pairs) {
    if (budgeted == null) {
      sight.findSeen(pairs);
    } else {
      budgeted.findSeen(pairs);
    }
  }

  /** The x coordinate of a target that the camera sees, as of its detection, in metres. */
  private double seenX(int camera, int target) {
    return budgeted == null ? targets.x(target) : budgeted.x(camera, target);
  }

  private double seenY(int camera, int target) {
    return budgeted == null ? targets.y(target) : budgeted.y(camera, target);
  }
}
