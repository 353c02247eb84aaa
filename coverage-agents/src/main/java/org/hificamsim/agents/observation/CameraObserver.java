package org.hificamsim.agents.observation;

import java.util.Arrays;
import org.hificamsim.agents.voting.NearestCameras;
import org.hificamsim.core.policy.NetworkView;

/**
 * Observes a network as each of its cameras knows it before a decision: what it sees where all are
 * now, and what was detected in the step before. One instance for one run, asked once before each
 * decision; a policy and an environment that ask at the same points get the same numbers.
 */
public final class CameraObserver {
  private final ObservationLayout layout;
  private final int size;
  private final Standpoints standpoints;
  private final OwnFeatures own;
  private final NearestCameras nearest;
  private final SeenTargets seen;
  private final int[] ways;

  /** Of the network as it is before the first decision. */
  public CameraObserver(NetworkView network, ObservationLayout layout) {
    this.layout = layout;
    size = layout.size();
    standpoints = new Standpoints(network);
    own = new OwnFeatures(network, standpoints);
    nearest = new NearestCameras(network, layout.neighbours());
    seen = new SeenTargets(network, layout.targets());
    ways = new int[network.cameras()];
  }

  /**
   * Observes for every camera.
   *
   * @param out receives the observations, one camera after the other
   */
  public void observe(NetworkView network, float[] out) {
    own.update(network);
    nearest.update(network);
    Arrays.fill(out, 0, ways.length * size, 0);
    for (int camera = 0; camera < ways.length; camera++) {
      ways[camera] = network.moving(camera) ? ways[camera] + 1 : 0;
      if (network.online(camera)) {
        write(network, camera, out, camera * size);
      }
    }
  }

  private void write(NetworkView network, int camera, float[] out, int at) {
    own.write(network, camera, ways[camera], out, at);
    writeNeighbours(network, camera, out, at + layout.firstNeighbour());
    if (layout.targets() > 0) {
      seen.write(network, camera, out, at + layout.firstTarget());
    }
  }

  private void writeNeighbours(NetworkView network, int camera, float[] out, int first) {
    int at = first;
    for (int i = 0; i < nearest.count(camera); i++) {
      int other = nearest.neighbour(camera, i);
      out[at] = standpoints.between(network.cameraX(other) - network.cameraX(camera));
      out[at + 1] = standpoints.between(network.cameraY(other) - network.cameraY(camera));
      out[at + 2] = Bounds.share((double) network.detected(other) / network.targets());
      at += ObservationLayout.NEIGHBOUR.size();
    }
  }
}
