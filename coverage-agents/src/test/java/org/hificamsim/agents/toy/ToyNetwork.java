package org.hificamsim.agents.toy;

import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.visibility.Body;

/**
 * A small network for tests, whose detections are set by the test or computed by a subclass. It
 * applies policies as the engine does and counts how often they use global knowledge, that is, more
 * than a camera sees itself.
 */
public class ToyNetwork implements OracleView {
  private static final Body FLAT = Body.flat(1);
  private final int[] views;
  private final int[] view;
  private final int targets;
  private final boolean[] online;
  private final boolean[] present;
  private final boolean[][][] detects;
  private final int[] chosen;
  private final int[] detected;
  private final int[] coverage;
  private Objective objective = Objective.kMin();
  private final ZoomLevel[][] zoomLevels;
  private final int[] moveStepsLeft;
  private int pans = 1;
  private int moveTime;
  private int revision;
  private long step;
  private long globalQueries;

  /** Creates a network with cameras online at their widest views, and all targets present. */
  public ToyNetwork(int targets, int... views) {
    this.targets = targets;
    this.views = views.clone();
    view = Arrays.stream(views).map(count -> count - 1).toArray();
    chosen = new int[views.length];
    moveStepsLeft = new int[views.length];
    zoomLevels = new ZoomLevel[views.length][];
    makeLevels();
    detected = new int[views.length];
    online = new boolean[views.length];
    Arrays.fill(online, true);
    present = new boolean[targets];
    Arrays.fill(present, true);
    coverage = new int[targets];
    detects = new boolean[views.length][][];
    for (int camera = 0; camera < views.length; camera++) {
      detects[camera] = new boolean[views[camera]][targets];
    }
  }

  /** Makes a camera detect exactly these targets in a view. */
  public final ToyNetwork see(int camera, int atView, int... seen) {
    Arrays.fill(detects[camera][atView], false);
    for (int target : seen) {
      detects[camera][atView][target] = true;
    }
    return this;
  }

  /** Sets the objective by which steps are scored. */
  public final ToyNetwork scoredBy(Objective newObjective) {
    objective = newObjective;
    return this;
  }

  /** The score of the last observation. */
  public final double score() {
    StepCoverage coverage = new StepCoverage(objective);
    coverage.measure(this);
    coverage.measureScore(this);
    return coverage.score();
  }

  protected final void see(int camera, int atView, int target, boolean seen) {
    detects[camera][atView][target] = seen;
  }

  /**
   * Arranges the views of each camera in pan angles, 30 degrees apart, if their number is
   * divisible; cameras begin ahead.
   */
  public final ToyNetwork turning(int newPans) {
    pans = newPans;
    for (int camera = 0; camera < view.length; camera++) {
      int zooms = zooms(camera);
      view[camera] = (views[camera] / zooms - 1) / 2 * zooms + zooms - 1;
    }
    makeLevels();
    return this;
  }

  private void makeLevels() {
    for (int camera = 0; camera < views.length; camera++) {
      int zooms = zooms(camera);
      zoomLevels[camera] = new ZoomLevel[zooms];
      Arrays.setAll(
          zoomLevels[camera],
          level -> new ZoomLevel(1.0 + level, 1, zooms, Double.NaN, 2 * Math.PI));
    }
  }

  /** Sets the number of additional steps of a move, in which the camera sees nothing. */
  public final ToyNetwork slow(int steps) {
    moveTime = steps;
    return this;
  }

  public final void switchCamera(int camera, boolean on) {
    online[camera] = on;
    revision++;
  }

  public final void showTarget(int target, boolean shown) {
    present[target] = shown;
  }

  /** Makes a step as the engine does: decide, apply, observe, learn. */
  public final void step(ZoomPolicy policy) {
    decide(policy);
    observe();
    policy.learn(this);
    nextStep();
  }

  /** Begins the next step. */
  public final void nextStep() {
    step++;
  }

  /** Lets the policy decide and applies its views. */
  public final void decide(ZoomPolicy policy) {
    System.arraycopy(view, 0, chosen, 0, view.length);
    policy.decide(this, chosen);
    for (int camera = 0; camera < view.length; camera++) {
      if (online[camera]) {
        moveStepsLeft[camera] =
            view[camera] == chosen[camera] ? Math.max(0, moveStepsLeft[camera] - 1) : moveTime;
        view[camera] = chosen[camera];
      }
    }
  }

  /** Counts what the cameras detect in their views. */
  public final void observe() {
    Arrays.fill(detected, 0);
    Arrays.fill(coverage, 0);
    for (int camera = 0; camera < view.length; camera++) {
      for (int target = 0; target < targets && online[camera]; target++) {
        if (seesNow(camera, target)) {
          detected[camera]++;
          coverage[target]++;
        }
      }
    }
  }

  private boolean seesNow(int camera, int target) {
    return online[camera]
        && present[target]
        && moveStepsLeft[camera] == 0
        && detects[camera][view[camera]][target];
  }

  /**
   * Returns k_min at the last observation (Eq 7.1); the number of cameras if no target is present.
   */
  public final int kMin() {
    int least = cameras();
    for (int target = 0; target < targets; target++) {
      least = present[target] ? Math.min(least, coverage[target]) : least;
    }
    return least;
  }

  /** The number of queries of detection sets, dominance or target positions. */
  public final long globalQueries() {
    return globalQueries;
  }

  public final int[] currentViews() {
    return view.clone();
  }

  public final void setView(int camera, int to) {
    view[camera] = to;
  }

  /** Starts the policy on this network. */
  public final <P extends ZoomPolicy> P begin(P policy, long seed) {
    policy.begin(this, new SplittableRandom(seed));
    return policy;
  }

  @Override
  public final long step() {
    return step;
  }

  @Override
  public final Objective objective() {
    return objective;
  }

  @Override
  public final int revision() {
    return revision;
  }

  @Override
  public final int cameras() {
    return views.length;
  }

  @Override
  public final String cameraName(int camera) {
    return "c" + camera;
  }

  @Override
  public final boolean online(int camera) {
    return online[camera];
  }

  @Override
  public double cameraX(int camera) {
    return camera;
  }

  @Override
  public double cameraY(int camera) {
    return 0;
  }

  @Override
  public double cameraHeading(int camera) {
    return 0;
  }

  @Override
  public final int views(int camera) {
    return views[camera];
  }

  @Override
  public final int view(int camera) {
    return view[camera];
  }

  @Override
  public final int zooms(int camera) {
    return views[camera] % pans == 0 ? views[camera] / pans : views[camera];
  }

  @Override
  public final double pan(int camera, int atView) {
    int count = views[camera] / zooms(camera);
    return Math.toRadians(30) * (atView / zooms(camera) - (count - 1) / 2);
  }

  @Override
  public final int seeing(int camera) {
    return moveStepsLeft[camera] > 0 ? -1 : view[camera];
  }

  @Override
  public final boolean sees(int camera, int target) {
    return seesNow(camera, target);
  }

  @Override
  public final double distance(int camera, int target) {
    long before = globalQueries;
    double distance = OracleView.super.distance(camera, target);
    globalQueries = before;
    return distance;
  }

  @Override
  public final double bearing(int camera, int target) {
    long before = globalQueries;
    double bearing = OracleView.super.bearing(camera, target);
    globalQueries = before;
    return bearing;
  }

  @Override
  public ZoomLevel zoom(int camera, int atView) {
    return zoomLevels[camera][atView % zooms(camera)];
  }

  @Override
  public final int detected(int camera) {
    return detected[camera];
  }

  @Override
  public final int targets() {
    return targets;
  }

  @Override
  public final String targetName(int target) {
    return "t" + target;
  }

  @Override
  public final boolean present(int target) {
    return present[target];
  }

  @Override
  public final double targetX(int target) {
    globalQueries++;
    return x(target);
  }

  @Override
  public final double targetY(int target) {
    globalQueries++;
    return y(target);
  }

  @Override
  public final int coverage(int target) {
    return coverage[target];
  }

  @Override
  public final double confidence(int camera, int target) {
    return detects[camera][view[camera]][target] ? 1 : 0;
  }

  /** A target in reach and angle is detected for certain, as far as light gets through. */
  @Override
  public boolean chancesAt(
      int camera, double x, double y, double size, double transmittance, double[] chances) {
    double dx = x - cameraX(camera);
    double dy = y - cameraY(camera);
    boolean any = false;
    for (int atView = 0; atView < views(camera); atView++) {
      double axis = cameraHeading(camera) + pan(camera, atView);
      double offAxis = Math.abs(Math.IEEEremainder(Math.atan2(dx, dy) - axis, 2 * Math.PI));
      boolean inView =
          Math.hypot(dx, dy) <= reach(camera, atView)
              && offAxis <= zoom(camera, atView).viewingAngle() / 2;
      chances[atView] = inView ? transmittance : 0;
      any |= inView;
    }
    return any;
  }

  /** The smallest rectangle that holds all cameras. */
  @Override
  public final Field field() {
    DoubleSummaryStatistics x =
        IntStream.range(0, cameras()).mapToDouble(this::cameraX).summaryStatistics();
    DoubleSummaryStatistics y =
        IntStream.range(0, cameras()).mapToDouble(this::cameraY).summaryStatistics();
    return new Field(x.getMin(), x.getMax(), y.getMin(), y.getMax());
  }

  /** The same body for all targets, so that a step allocates nothing. */
  @Override
  public final Body body(double size) {
    return FLAT;
  }

  @Override
  public boolean certain() {
    return true;
  }

  @Override
  public final boolean detects(int camera, int atView, int target) {
    globalQueries++;
    return detects[camera][atView][target];
  }

  @Override
  public final boolean dominates(int camera, int atView, int other) {
    globalQueries++;
    return provenSuperset(camera, atView, other);
  }

  protected double x(int target) {
    return target;
  }

  protected double y(int target) {
    return 0;
  }

  protected boolean provenSuperset(int camera, int atView, int other) {
    return atView == other;
  }
}
