package org.hificamsim.network;

import java.util.Random;

/**
 * The network's random streams, each seeded with the run's seed as the world's are (behaviour 4.1).
 */
record NetworkStreams(Random communication, Random error, Random bandit) {
  static NetworkStreams of(long seed) {
    return new NetworkStreams(new Random(seed), new Random(seed), new Random(seed));
  }
}
