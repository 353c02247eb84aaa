package org.hificamsim.network.statistics;

import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;
import org.hificamsim.network.agent.Agent;

/**
 * What a camera's targets are worth: its utility (behaviour 10.3) and its relative confidence
 * (behaviour 10.4).
 *
 * <p>{@link #measure} fills the figures of one camera, to be read before the next is measured.
 */
public final class CameraFigures {
  private static final double MAX_RANGE = 20;

  private final Cameras cameras;
  private final Targets targets;
  private final Field field;
  private double sum;
  private int visible;

  /** Figures of a world's cameras. */
  public CameraFigures(World world) {
    cameras = world.cameras();
    targets = world.targets();
    field = world.scenario().field();
  }

  /** The visibility of the targets owned, weighed by the camera's range. */
  public double utility(Agent agent) {
    double worth = Math.max(worth(agent.camera()), 0);
    double utility = 0.0;
    for (int target : agent.owned()) {
      utility += agent.confidence(target) * worth;
    }
    return utility;
  }

  /** Measures what the camera owns and sees. */
  public void measure(Agent agent) {
    sum = 0.0;
    visible = 0;
    for (int target : agent.copyOfOwned()) {
      if (agent.sees(target)) {
        sum += certainty(agent.camera(), target);
        visible++;
      }
    }
  }

  /** The sum of the certainties of targets owned and seen. */
  public double sumOfCertainties() {
    return sum;
  }

  /** How many targets are owned and seen. */
  public int tracked() {
    return visible;
  }

  /** The mean certainty of the targets owned and seen; 0 without any. */
  public double relativeConfidence() {
    return sum == 0 ? 0 : sum / visible;
  }

  private double worth(int camera) {
    return 0.95 * (1 - cameras.range(camera) / MAX_RANGE) - 0.15;
  }

  private double certainty(int camera, int target) {
    double dx = (targets.x(target) - field.minX()) - (cameras.x(camera) - field.minX());
    double dy = (field.minY() + targets.y(target)) * -1 - (field.minY() + cameras.y(camera)) * -1;
    double distance = Math.sqrt(dx * dx + dy * dy);
    double certainty = (1 - distance / MAX_RANGE) * worth(camera);
    return certainty < 0 ? 0 : certainty;
  }
}
