package org.hificamsim.core.engine;

import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.world.World;

/** An observed network that also has the knowledge that no camera has. */
class OracleNetwork extends ObservedNetwork implements OracleView {
  OracleNetwork(World world, Sight sight, Observation observation) {
    super(world, sight, observation);
  }

  @Override
  public double targetX(int target) {
    return targets.x(target);
  }

  @Override
  public double targetY(int target) {
    return targets.y(target);
  }

  @Override
  public double presentPan(int camera) {
    return cameras.presentPan(camera);
  }

  @Override
  public double presentZoom(int camera) {
    return cameras.presentZoom(camera);
  }

  @Override
  public boolean certain() {
    return sight.certain();
  }

  @Override
  public boolean detects(int camera, int view, int target) {
    return sight.detects(camera, view, target);
  }

  @Override
  public double chance(int camera, int view, int target) {
    return sight.chance(camera, view, target);
  }

  @Override
  public int chances(int camera, int view, int[] possible, double[] chances) {
    return sight.chances(camera, view, possible, chances);
  }

  @Override
  public boolean dominates(int camera, int view, int other) {
    return sight.dominates(camera, view, other);
  }

  @Override
  public void detections(int camera, long[] masks, int words) {
    sight.detections(camera, masks, words);
  }
}
