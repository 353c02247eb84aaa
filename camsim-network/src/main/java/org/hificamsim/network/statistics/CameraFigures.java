package org.hificamsim.network.statistics;

import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;
import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.OwnedTargets;

/**
 * The figures of a camera: its utility (behaviour 10.3) and its relative confidence (behaviour
 * 10.4).
 *
 * <p>{@link #measure} computes the figures of one camera; they are valid until its next call.
 */
public final class CameraFigures {
  private static final double MAX_RANGE = 20;

  private final Cameras cameras;
  private final Targets targets;
  private final Field field;
  private double certaintySum;
  private int trackedTargets;

  /** Creates the figures of a world's cameras. */
  public CameraFigures(World world) {
    cameras = world.cameras();
    targets = world.targets();
    field = world.scenario().field();
  }

  /** The sum of the confidences of owned targets, times a factor that falls with the range. */
  public double utility(Agent agent) {
    double rangeFactor = Math.max(rangeFactor(agent.camera()), 0);
    double utility = 0.0;
    OwnedTargets owned = agent.owned();
    for (int i = 0; i < owned.count(); i++) {
      utility += agent.confidence(owned.target(i)) * rangeFactor;
    }
    return utility;
  }

  /** Measures the targets that a camera owns and sees. */
  public void measure(Agent agent) {
    certaintySum = 0.0;
    trackedTargets = 0;
    OwnedTargets owned = agent.owned();
    for (int i = 0; i < owned.count(); i++) {
      int target = owned.targetOfCopy(i);
      if (agent.sees(target)) {
        certaintySum += certainty(agent.camera(), target);
        trackedTargets++;
      }
    }
  }

  /** The sum of the certainties of the targets owned and seen. */
  public double sumOfCertainties() {
    return certaintySum;
  }

  /** The number of targets owned and seen. */
  public int tracked() {
    return trackedTargets;
  }

  /** The mean certainty of the targets owned and seen; 0 without any. */
  public double relativeConfidence() {
    return certaintySum == 0 ? 0 : certaintySum / trackedTargets;
  }

  private double rangeFactor(int camera) {
    return 0.95 * (1 - cameras.range(camera) / MAX_RANGE) - 0.15;
  }

  private double certainty(int camera, int target) {
    double dx = (targets.x(target) - field.minX()) - (cameras.x(camera) - field.minX());
    double dy = (field.minY() + targets.y(target)) * -1 - (field.minY() + cameras.y(camera)) * -1;
    double distance = Math.sqrt(dx * dx + dy * dy);
    double certainty = (1 - distance / MAX_RANGE) * rangeFactor(camera);
    return certainty < 0 ? 0 : certainty;
  }
}
