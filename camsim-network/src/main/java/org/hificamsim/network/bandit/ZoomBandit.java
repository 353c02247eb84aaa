package org.hificamsim.network.bandit;

import org.hificamsim.core.world.World;
import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.Mean;
import org.hificamsim.network.statistics.CameraFigures;

/**
 * A bandit whose arms are ranges: changes the range of a camera every eleventh step (behaviour
 * 9.6). Cameras with a lens cannot have it, since their range is fixed.
 */
public final class ZoomBandit implements CameraBandit {
  private static final double MAX_RANGE = 20;
  private static final double ARM_WIDTH = MAX_RANGE / Arms.COUNT;
  private static final int PERIOD = 10;

  private final BanditSolver solver;
  private final Agent agent;
  private final World world;
  private final Mean keptInView = new Mean();
  private final Mean sharedViews = new Mean();
  private final Mean certainty = new Mean();
  private int ticks;

  /** Creates the bandit of a camera, which starts with its current range. */
  public ZoomBandit(BanditSolver solver, Agent agent, World world) {
    this.solver = solver;
    this.agent = agent;
    this.world = world;
  }

  @Override
  public void learn(double earned, int attempts, CameraFigures figures) {
    addFigures(figures);
    if (++ticks > PERIOD) {
      chooseRange();
    }
  }

  /** Forgets the figures of the range before, without a reward for it (behaviour 9.6). */
  @Override
  public void rangeChanged() {
    keptInView.take();
    sharedViews.take();
    certainty.take();
  }

  private void addFigures(CameraFigures figures) {
    int owned = agent.owned().count();
    if (owned > 0) {
      keptInView.add((double) figures.tracked() / owned, 1);
    }
    if (!agent.sharedViews().isEmpty()) {
      sharedViews.add(agent.sharedViews().take(), 1);
    }
    certainty.add(figures.sumOfCertainties(), figures.tracked());
  }

  private void chooseRange() {
    double range = world.cameras().range(agent.camera());
    int arm = solver.current();
    solver.arms().reward(arm == BanditSolver.NONE ? armOf(range) : arm, reward());
    solver.choose();
    if (solver.current() != BanditSolver.NONE) {
      changeRange(range, (solver.current() + 1) * ARM_WIDTH - range);
    }
    ticks = 0;
  }

  private double reward() {
    BanditParameters parameters = solver.parameters();
    return parameters.alpha() * keptInView.take()
        + parameters.beta() * sharedViews.take()
        + parameters.gamma() * certainty.take();
  }

  /** Changes the range by CamSim's rule (behaviour 6.3, quirk Q10). */
  private void changeRange(double range, double change) {
    double changed = range + change;
    world.changeRange(agent.camera(), changed >= MAX_RANGE ? MAX_RANGE - MAX_RANGE * 0.2 : changed);
  }

  /** The arm with the next larger range, for a range that no arm has set. */
  private static int armOf(double range) {
    return Math.min((int) Math.floor(range / ARM_WIDTH), Arms.COUNT - 1);
  }
}
