package org.hificamsim.agents.temporal;

import java.util.Arrays;
import org.hificamsim.core.policy.CameraTask;
import org.hificamsim.core.policy.NetworkView;

/** What each camera perceives, as a number from 0. */
final class Percepts {
  private static final CameraTask<Percepts> LOOKING =
      (network, percepts, from, to) -> percepts.look(network, from, to);

  private final PicturePercept[] pictures;

  Percepts(NetworkView network, StateReading reading) {
    pictures = new PicturePercept[reading.parts() == 0 ? 0 : network.cameras()];
    Arrays.setAll(pictures, camera -> new PicturePercept(reading.parts() > PicturePercept.THIRDS));
  }

  /** Lets all cameras look; what they detected last needs no look. */
  void update(NetworkView network) {
    if (pictures.length > 0) {
      network.divide(this, LOOKING);
    }
  }

  private void look(NetworkView network, int from, int to) {
    for (int camera = from; camera < to; camera++) {
      pictures[camera].look(network, camera);
    }
  }

  /** What the camera perceived at the last update. */
  int of(NetworkView network, int camera) {
    return pictures.length == 0 ? network.detected(camera) : pictures[camera].parts();
  }

  /** What the camera perceives now. */
  int now(NetworkView network, int camera) {
    return pictures.length == 0 ? network.detected(camera) : pictures[camera].look(network, camera);
  }
}
