package org.hificamsim.network.files;

import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Cooperation;
import org.hificamsim.core.engine.NetworkModel;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.world.World;
import org.hificamsim.network.Network;
import org.hificamsim.network.NetworkSettings;

/** CamSim's network where a plan names it. */
public final class CamSimNetwork implements NetworkModel {
  private NetworkSettings settings = NetworkSettings.CAMSIM;

  @Override
  public String name() {
    return NetworkText.NAME;
  }

  @Override
  public void configure(Options options) {
    settings = NetworkText.settings(options);
  }

  @Override
  public Cooperation begin(World world, Detection detection, long seed) {
    return new Network(world, detection, settings, seed);
  }
}
