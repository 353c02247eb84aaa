package org.hificamsim.worlds;

import java.util.Arrays;
import org.hificamsim.core.channel.RadioLog;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;

/**
 * The contribution of each camera in a step: the targets that it sees, the targets that only it
 * sees, and the bits that it sends.
 */
final class CameraDetails {
  /** The number of values for each camera: seen, added, sent. */
  static final int COUNT = 3;

  private final SeenPairs pairs = new SeenPairs();
  private final float[] values;
  private final long[] sentBefore;
  private RadioLog radio = RadioLog.NONE;

  CameraDetails(int cameras) {
    values = new float[cameras * COUNT];
    sentBefore = new long[cameras];
  }

  /** Begins an episode, whose messages a log counts. */
  void begin(RadioLog newRadio) {
    radio = newRadio;
    Arrays.fill(sentBefore, 0);
    Arrays.fill(values, 0);
  }

  /** Measures a step. A target counts as added if no other camera detects it. */
  void measure(NetworkView network) {
    Arrays.fill(values, 0);
    network.findSeen(pairs);
    for (int i = 0; i < pairs.count(); i++) {
      int offset = pairs.camera(i) * COUNT;
      values[offset]++;
      values[offset + 1] += network.coverage(pairs.target(i)) == 1 ? 1 : 0;
    }
    for (int camera = 0; camera < sentBefore.length; camera++) {
      values[camera * COUNT + 2] = radio.everSent(camera) - sentBefore[camera];
      sentBefore[camera] = radio.everSent(camera);
    }
  }

  /** The values of the last step, one camera after the other. */
  float[] values() {
    return values;
  }
}
