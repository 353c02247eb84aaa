package org.hificamsim.core.engine;

import static org.hificamsim.core.energy.EnergyFigure.DETECTION;
import static org.hificamsim.core.energy.EnergyFigure.IDLE;
import static org.hificamsim.core.energy.EnergyFigure.PAN;
import static org.hificamsim.core.energy.EnergyFigure.PIXEL;
import static org.hificamsim.core.energy.EnergyFigure.RECEIVE;
import static org.hificamsim.core.energy.EnergyFigure.SEND;
import static org.hificamsim.core.energy.EnergyFigure.SENSE;
import static org.hificamsim.core.energy.EnergyFigure.SLEEP;
import static org.hificamsim.core.energy.EnergyFigure.ZOOM;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import org.hificamsim.core.channel.RadioLog;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.energy.EnergyFigure;
import org.hificamsim.core.energy.EnergyModel;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;

/**
 * Measures the energy that each camera takes in each step, and switches off cameras whose battery
 * is empty.
 *
 * <p>A camera whose battery runs empty in a step still sees through that step. Afterwards it is
 * offline for the rest of the run, as by an event.
 */
public final class EnergyMeter {
  private static final double PICTURE_HEIGHT_OVER_WIDTH = 0.75;

  private final EnergyModel model;
  private final World world;
  private final Cameras cameras;
  private final RadioLog radio;
  private final double stepTime;

  /** The joules of each figure, by camera. */
  private final Map<EnergyFigure, double[]> joules = new EnumMap<>(EnergyFigure.class);

  private final double[] left;
  private final double[] lastPan;
  private final int[] lastZoom;
  private final boolean[] measuredBefore;
  private long steps;
  private int empty;
  private long coveredTargets;
  private long allTargets;
  private double sum;
  private double firstEmpty = Double.NaN;
  private double halfEmpty = Double.NaN;
  private double coveredUntilFirst = Double.NaN;
  private double coveredUntilHalf = Double.NaN;

  /** Creates the meter of a world before its first step. */
  public EnergyMeter(World world, RadioLog radio) {
    this.model = world.scenario().energy();
    this.world = world;
    this.cameras = world.cameras();
    this.radio = radio;
    this.stepTime = world.scenario().stepTime();
    int count = cameras.count();
    for (EnergyFigure figure : EnergyFigure.values()) {
      joules.put(figure, new double[count]);
    }
    left = new double[count];
    Arrays.fill(left, model.battery());
    lastPan = new double[count];
    lastZoom = new int[count];
    measuredBefore = new boolean[count];
  }

  /** Measures a step that has been observed; called before targets move on. */
  public void measure(NetworkView network, StepCoverage coverage) {
    steps++;
    coveredTargets += coverage.targets() - coverage.covered0();
    allTargets += coverage.targets();
    for (int camera = 0; camera < left.length; camera++) {
      double taken = measure(network, camera);
      sum += taken;
      left[camera] -= taken;
    }
    switchOffEmpty();
    radio.clear();
  }

  /** Measures a camera; returns the joules that it took in this step. */
  private double measure(NetworkView network, int camera) {
    if (cameras.online(camera)) {
      return measureAwake(network, camera);
    }
    return world.sleeps(camera) ? take(camera, SLEEP, stepTime) : 0;
  }

  private double measureAwake(NetworkView network, int camera) {
    double taken =
        take(camera, IDLE, stepTime)
            + take(camera, SEND, (double) radio.sent(camera))
            + take(camera, RECEIVE, (double) radio.received(camera))
            + takeForMoves(network, camera);
    int view = cameras.seeing(camera);
    if (view == Cameras.NO_VIEW) {
      return taken;
    }
    ZoomLevel zoom = cameras.zoom(camera, view);
    double pixels = PICTURE_HEIGHT_OVER_WIDTH * zoom.pixels() * zoom.pixels();
    return taken
        + take(camera, SENSE, 1)
        + take(camera, PIXEL, pixels)
        + take(camera, DETECTION, network.detected(camera));
  }

  private double takeForMoves(NetworkView network, int camera) {
    int view = cameras.view(camera);
    double pan = cameras.pan(camera, view);
    int zoom = network.zoomOf(camera, view);
    double degrees =
        Math.toDegrees(Math.abs(Math.IEEEremainder(pan - lastPan[camera], 2 * Math.PI)));
    int levels = Math.abs(zoom - lastZoom[camera]);
    double taken =
        measuredBefore[camera] ? take(camera, PAN, degrees) + take(camera, ZOOM, levels) : 0;
    measuredBefore[camera] = true;
    lastPan[camera] = pan;
    lastZoom[camera] = zoom;
    return taken;
  }

  private double take(int camera, EnergyFigure figure, double amount) {
    double taken = model.figure(figure) * amount;
    joules.get(figure)[camera] += taken;
    return taken;
  }

  private void switchOffEmpty() {
    for (int camera = 0; camera < left.length && model.hasBatteries(); camera++) {
      if (left[camera] <= 0 && !world.isOff(camera)) {
        world.switchOffForEver(camera);
        empty++;
        noteEmpty();
      }
    }
  }

  private void noteEmpty() {
    double covered = allTargets == 0 ? Double.NaN : (double) coveredTargets / allTargets;
    if (empty == 1) {
      firstEmpty = steps;
      coveredUntilFirst = covered;
    }
    if (2 * empty >= left.length && Double.isNaN(halfEmpty)) {
      halfEmpty = steps;
      coveredUntilHalf = covered;
    }
  }

  /** The energy that a camera has used for a figure so far, in joules. */
  public double joules(int camera, EnergyFigure figure) {
    return joules.get(figure)[camera];
  }

  /** The charge left in the battery of a camera, in joules; 0 or less once it is empty. */
  public double left(int camera) {
    return left[camera];
  }

  /** The sums over all steps so far. */
  public EnergySums sums() {
    return new EnergySums(sum, firstEmpty, halfEmpty, coveredUntilFirst, coveredUntilHalf);
  }
}
