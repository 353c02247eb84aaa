package org.hificamsim.agents.observation;

import java.util.Arrays;
import org.hificamsim.agents.voting.NearestCameras;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;

/**
 * Observes a network as each of its cameras knows it before a decision: what it sees where all are
 * now, and what was detected in the step before. One instance for one run, asked once before each
 * decision; a policy and an environment that ask at the same points get the same numbers.
 */
public final class CameraObserver {
  private static final int MOVING = ObservationLayout.at("moving");
  private static final int WAY = ObservationLayout.at("way");
  private static final int DETECTED = ObservationLayout.at("detected");

  private final ObservationLayout layout;
  private final int size;
  private final Standpoints standpoints;
  private final NearestCameras nearest;
  private final SeenTargets seen;
  private final Shares ofTargets;
  private final SeenPairs pairs = new SeenPairs();
  private final int[] ways; // decisions since the camera set out
  private ViewFeatures views;
  private int revision;

  /** Of the network as it is before the first decision. */
  public CameraObserver(NetworkView network, ObservationLayout layout) {
    this(
        network,
        layout,
        new SeenTargets(network, layout),
        new Shares(Math.max(1, network.targets())));
  }

  private CameraObserver(
      NetworkView network, ObservationLayout layout, SeenTargets seen, Shares ofTargets) {
    this.layout = layout;
    this.seen = seen;
    this.ofTargets = ofTargets;
    size = layout.size();
    standpoints = new Standpoints(network);
    nearest = new NearestCameras(network, layout.neighbours());
    ways = new int[network.cameras()];
    note(network);
  }

  /**
   * Of another network of the same scenario: what both know alike is kept once.
   *
   * @param other with the same layout
   */
  public CameraObserver(NetworkView network, ObservationLayout layout, CameraObserver other) {
    this(network, layout, other.seen, other.ofTargets);
    views = views.or(other.views);
  }

  private void note(NetworkView network) {
    revision = network.revision();
    nearest.update(network);
    views = new ViewFeatures(network, layout, standpoints, nearest);
  }

  /** Observes for every camera. */
  public void observe(NetworkView network, float[] out) {
    observe(network, pairs, out);
  }

  /**
   * Observes for every camera.
   *
   * @param pairs is used meanwhile
   * @param out receives the observations, one camera after the other
   */
  public void observe(NetworkView network, SeenPairs pairs, float[] out) {
    if (network.revision() != revision) {
      note(network);
    }
    boolean allOnline = true;
    for (int camera = 0; camera < ways.length; camera++) {
      ways[camera] = network.moving(camera) ? ways[camera] + 1 : 0;
      write(network, camera, out);
      allOnline &= network.online(camera);
    }
    views.copyToNeighbours(out, DETECTED);
    if (layout.targets() > 0) {
      seen.write(network, pairs, views, out);
    }
    if (!allOnline) {
      clearOffline(network, out);
    }
  }

  private void write(NetworkView network, int camera, float[] out) {
    int at = camera * size;
    views.write(camera, network.view(camera), network.seeing(camera), out, at);
    int way = ways[camera];
    out[at + MOVING] = way > 0 ? 1 : 0;
    out[at + WAY] = way / (way + 1f);
    out[at + DETECTED] = ofTargets.of(network.detected(camera)); // 0 while it is off
  }

  private void clearOffline(NetworkView network, float[] out) {
    for (int camera = 0; camera < ways.length; camera++) {
      if (!network.online(camera)) {
        Arrays.fill(out, camera * size, (camera + 1) * size, 0);
      }
    }
  }
}
