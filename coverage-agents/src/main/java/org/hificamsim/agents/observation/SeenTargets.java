package org.hificamsim.agents.observation;

import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;

/** The targets that cameras see, the nearest first; of equally near ones the lower number. */
final class SeenTargets {
  private final ObservationLayout layout;
  private final Shares ofCameras;

  SeenTargets(NetworkView network, ObservationLayout layout) {
    this.layout = layout;
    ofCameras = new Shares(network.cameras());
  }

  /**
   * Writes the nearest ones of each camera, as many as there is room for.
   *
   * @param pairs has who sees whom on return
   * @param out the observations of all cameras, 0 where no target is seen
   */
  void write(NetworkView network, SeenPairs pairs, ViewFeatures views, float[] out) {
    network.findSeen(pairs);
    pairs.sort(layout.targets());
    int camera = -1;
    int shown = 0;
    for (int pair = 0; pair < pairs.count(); pair++) {
      shown = pairs.camera(pair) == camera ? shown + 1 : 0;
      camera = pairs.camera(pair);
      if (shown < layout.targets()) {
        int at = layout.firstTarget() + shown * ObservationLayout.TARGET.size();
        write(network, pairs, pair, views, out, camera * layout.size() + at);
      }
    }
  }

  private void write(
      NetworkView network, SeenPairs pairs, int pair, ViewFeatures views, float[] out, int at) {
    int camera = pairs.camera(pair);
    int target = pairs.target(pair);
    double distance = pairs.distance(pair);
    int view = network.seeing(camera);
    double perReach = views.perReach(camera, view);
    out[at] = 1;
    out[at + 1] = Bounds.signed(pairs.ahead(pair) * perReach);
    out[at + 2] = Bounds.signed(pairs.right(pair) * perReach);
    out[at + 3] =
        Bounds.share(network.targetSize(target) / distance * views.perAngle(camera, view));
    out[at + 4] = Bounds.share(network.seenConfidence(camera, target, distance));
    out[at + 5] = ofCameras.of(network.coverage(target));
  }
}
