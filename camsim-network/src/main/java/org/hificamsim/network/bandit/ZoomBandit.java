package org.hificamsim.network.bandit;

import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;
import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.ViewTally;
import org.hificamsim.network.statistics.CameraFigures;

/** A bandit whose arms are ranges: changes a camera's range every eleventh step (section 9.6). */
public final class ZoomBandit {
  private static final double MOST_RANGE = 20;
  private static final double ARM_WIDTH = MOST_RANGE / Arms.COUNT;
  private static final int PERIOD = 10;

  private final BanditSolver solver;
  private final World world;
  private final Cameras cameras;
  private int ticks;
  private double ratios;
  private int ratioCount;
  private double sharedRatios;
  private int sharedRatioCount;
  private double certainties;
  private int certaintyCount;

  public ZoomBandit(BanditSolver solver, World world) {
    this.solver = solver;
    this.world = world;
    this.cameras = world.cameras();
  }

  /**
   * Takes a camera's step into account, and chooses a new range when it is time.
   *
   * @param figures as measured for this camera
   */
  public void updated(Agent agent, CameraFigures figures) {
    note(agent, figures);
    if (++ticks > PERIOD) {
      int arm = solver.current();
      double range = range(agent.camera());
      solver.arms().reward(arm == BanditSolver.NONE ? armOf(range) : arm, reward());
      solver.choose();
      if (solver.current() != BanditSolver.NONE) {
        reach(agent.camera(), range, (solver.current() + 1) * ARM_WIDTH - range);
      }
      forget();
    }
    agent.tally().reset();
  }

  private void note(Agent agent, CameraFigures figures) {
    int owned = agent.owned().size();
    if (owned > 0) {
      ratios += (double) figures.tracked() / owned;
      ratioCount++;
    }
    ViewTally tally = agent.tally();
    if (tally.counted()) {
      sharedRatios += tally.sharedRatio();
      sharedRatioCount++;
    }
    certainties += figures.sumOfCertainties();
    certaintyCount += figures.tracked();
  }

  private double reward() {
    BanditParameters parameters = solver.parameters();
    return parameters.alpha() * mean(ratios, ratioCount)
        + parameters.beta() * mean(sharedRatios, sharedRatioCount)
        + parameters.gamma() * mean(certainties, certaintyCount);
  }

  private void forget() {
    ticks = 0;
    ratios = 0;
    ratioCount = 0;
    sharedRatios = 0;
    sharedRatioCount = 0;
    certainties = 0;
    certaintyCount = 0;
  }

  /** CamSim's rule for a range that changes (section 6.3, quirk Q10). */
  private void reach(int camera, double range, double change) {
    double changed = range + change;
    world.changeRange(camera, changed >= MOST_RANGE ? MOST_RANGE - MOST_RANGE * 0.2 : changed);
  }

  private double range(int camera) {
    return cameras.zoom(camera, cameras.level(camera)).radius();
  }

  /** The arm whose range is nearest from above, for a range that no arm has set. */
  private static int armOf(double range) {
    return Math.min((int) Math.floor(range / ARM_WIDTH), Arms.COUNT - 1);
  }

  private static double mean(double sum, int count) {
    return count == 0 ? 0 : sum / count;
  }
}
